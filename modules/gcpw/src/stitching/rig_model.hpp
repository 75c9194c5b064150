// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#ifndef OPENCV_GCPW_RIG_MODEL_HPP
#define OPENCV_GCPW_RIG_MODEL_HPP

#include <memory>
#include <vector>
#include "model/mesh_grid.hpp"
#include "opencv2/gcpw/rig.hpp"

namespace cv
{
namespace gcpw
{

/** @brief The mesh of one image on the canvas of a base warper of some scale.

The base warper's canvas is angles (or plane coordinates) times scale: it has no half-pixel offset, so that a mesh at another
scale is the mesh times the ratio. The lattice's own reference pixels are the estimation's; referencePoint() converts. */
class PlacedMesh
{
public:
    /// @param image of an alignment  @param canvas_scale see Alignment::canvasScale()  @param ratio scale / estimation scale
    PlacedMesh(const Alignment::Image& image, Size2d canvas_scale, double ratio);

    const MeshGrid& mesh() const { return mesh_; }

    /// Point of the base warper's canvas that the mesh carries to a canvas point: the inverse of canvasAt().
    Point2d referenceAt(Point2d canvas_px, int& hint) const;

    /// Canvas point of a point of the base warper's canvas. Outside the mesh the motion of the nearest border point is
    /// used: extrapolating stretched border quads would not be stable.
    Point2d canvasAt(Point2d reference_canvas_px) const;

    /// Base canvas point of a point of the lattice, and its inverse.
    Point2d referencePoint(Point2d lattice_px) const;
    Point2d latticePoint(Point2d reference_canvas_px) const;

private:
    MeshGrid mesh_; ///< lattice px -> canvas px
    Point2d step_;  ///< canvas px per lattice px
    Point2d start_; ///< base canvas point of lattice point (0, 0)
};

/// A usable rig, ready to be rendered.
class RigModel
{
public:
    struct Item
    {
        Alignment::Image image;
        Matx33f R;                    ///< of the camera
        double seam_rotation_rad = 0; ///< see Rig::turns
        bool isIdentity = false;      ///< the mesh is where the base warper has the image
    };

    /// Nothing if the rig is not usable; if its parts contradict each other, what is wrong is logged.
    static std::shared_ptr<const RigModel> create(const Rig& rig);

    const std::vector<Item>& items() const { return items_; }
    float scale() const { return scale_; }
    PlacedMesh place(int index, double scale) const
    {
        return {items_[index].image, canvas_scale_, scale / scale_};
    }

    /// Images whose camera has this rotation.
    std::vector<int> find(const Matx33f& R) const;

private:
    std::vector<Item> items_;
    Size2d canvas_scale_;
    float scale_ = 1;
};

} // namespace gcpw
} // namespace cv

#endif
