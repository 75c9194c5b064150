// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#ifndef OPENCV_GCPW_MESH_GRID_HPP
#define OPENCV_GCPW_MESH_GRID_HPP

#include <vector>
#include "geometry/lattice.hpp"

namespace cv
{
namespace gcpw
{

/** @brief Canvas positions on the vertices of a lattice: the warp of one image, bilinear in every quad.

Canvas pixels, at the working resolution. A quad is *folded* where its map stops being one-to-one; a bilinear quad is
one-to-one exactly if the four triangles at its corners keep their orientation, which is what cornerArea() measures. */
class MeshGrid
{
public:
    MeshGrid() = default;

    /// The undeformed lattice, shifted to `origin`: canvas = reference + origin.
    explicit MeshGrid(const Lattice& lattice, Point2d origin = Point2d());

    const Lattice& lattice() const { return lattice_; }
    const std::vector<Point2d>& vertices() const { return vertices_; }
    std::vector<Point2d>& vertices() { return vertices_; }
    Point2d vertex(int cell, int corner) const { return vertices_[lattice_.vertexOf(cell, corner)]; }

    /// Canvas position of a reference point.
    Point2d warp(const CellPoint& point) const;
    Point2d warp(Point2d reference_px) const { return warp(lattice_.locate(reference_px)); }

    /// d canvas / d reference at a cell point: [dx/dx dx/dy; dy/dx dy/dy].
    Matx22d jacobian(const CellPoint& point) const;

    /** @brief The reference point that is carried to a canvas point.
    @param canvas_px where to look
    @param hint cell to start from (any value; out of range starts in the middle); the found cell on return
    @param point the result; its weights are valid only if true is returned
    @return false where the mesh does not cover the point */
    bool invert(Point2d canvas_px, int& hint, CellPoint& point) const;

    /// Twice the signed area of the triangle at a corner of a quad (corner, next along the row, next along the column).
    double cornerArea(int cell, int corner) const;

    /// Whether the mesh is the undeformed lattice, only shifted; `origin` receives the shift.
    bool isTranslation(Point2d& origin) const;

    /// How many quads are folded or flipped.
    int countFolds() const;

    /// The smallest upright rectangle around the mesh, canvas pixels.
    Rect2d bounds() const;

private:
    /// Whether a quad covers a canvas point; `fractions` say in either case where the point lies, in cells from its corner.
    bool findIn(int cell, Point2d canvas_px, CellPoint& point, Point2d& fractions) const;

    Lattice lattice_;
    std::vector<Point2d> vertices_;
};

/// Twice the signed area of the corner triangle of a quad whose corners are given in lattice order.
double cornerArea(const std::array<Point2d, 4>& quad, int corner);

/// Inverts the bilinear map of one quad: fractions (u, v) with point = sum w_k(u, v) quad[k], on the sheet the quad
/// itself lies on. False if there are none.
bool invertBilinear(const std::array<Point2d, 4>& quad, Point2d point, double& u, double& v);

/// How far outside [0, 1] a fraction still counts as on the border of its quad, so that no gap opens between two quads.
const double BORDER_FRACTION = 1e-9;

/// Whether fractions as of invertBilinear() lie in the quad or on its border; false for NaN.
bool isInQuad(double u, double v);

/// Largest move of a vertex between two meshes over one lattice, canvas pixels.
double maxVertexDistance(const MeshGrid& a, const MeshGrid& b);

/// mesh + step
MeshGrid moved(const MeshGrid& mesh, const std::vector<Point2d>& step);

} // namespace gcpw
} // namespace cv

#endif
