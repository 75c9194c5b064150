// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#ifndef OPENCV_GCPW_WARP_MAPS_HPP
#define OPENCV_GCPW_WARP_MAPS_HPP

#include <opencv2/stitching/detail/warpers.hpp>
#include "stitching/base_maps.hpp"
#include "stitching/rig_model.hpp"

namespace cv
{
namespace gcpw
{

/// Base warper followed by a mesh, for one camera at one scale: points, rectangle and maps.
class WarpMaps
{
public:
    /// @param seam_rotation_rad by which the mesh's own frame is rotated off the seam; see rotateOffSeam()
    WarpMaps(cv::detail::RotationWarper& base, const PlacedMesh& placed, const Mat& K, const Matx33f& R, double seam_rotation_rad);

    Point2f canvasAt(Point2f image_px) const;
    Point2f imageAt(Point2f canvas_px) const;

    /// Canvas rectangle that holds the picture of an image.
    Rect roi(Size image) const;

    /// Image position of every canvas pixel of roi; (-1, -1) beside the mesh. CV_32FC1 each.
    void build(Size image, Rect roi, Mat& x_map, Mat& y_map) const;

    /// The same with baseMaps() at hand, for several parts of a roi.
    void build(const BaseMaps& base, Rect roi, Mat& x_map, Mat& y_map) const;
    BaseMaps baseMaps(Size image) const;

    /// Position of every image pixel in a picture whose top-left pixel is `corner`. CV_32FC1 each.
    void buildForward(Size image, Point corner, Mat& x_map, Mat& y_map) const;

private:
    Point2d referenceCanvasAt(Point2f image_px) const;
    void look(const MeshGrid& mesh, const BaseMaps& base, Rect roi, Mat& x_map, Mat& y_map) const;

    cv::detail::RotationWarper& base_;
    PlacedMesh placed_;
    Mat K_;
    Mat R_; ///< rotated off the seam
    Mat plain_R_;
    double turn_px_;
    double period_px_; ///< 0 unless the image was rotated
};

} // namespace gcpw
} // namespace cv

#endif
