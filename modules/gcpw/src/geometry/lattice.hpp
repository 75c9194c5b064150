// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#ifndef OPENCV_GCPW_LATTICE_HPP
#define OPENCV_GCPW_LATTICE_HPP

#include <algorithm>
#include <array>
#include <cmath>
#include <opencv2/core.hpp>

namespace cv
{
namespace gcpw
{

/** @brief A point of the reference frame, as a cell of a lattice and the bilinear weights of its four corners.

Corners are numbered as in eq. st1: 0 top left, 1 top right, 2 bottom left, 3 bottom right. Weights sum to one and are
non-negative inside the lattice. */
struct CellPoint
{
    int cell = -1;
    std::array<double, 4> weight{{0, 0, 0, 0}};
};

/** @brief A uniform grid of cols x rows cells over the pixels of a reference image: indices and weights, never values.

It covers the pixel squares, [-0.5, width - 0.5] x [-0.5, height - 0.5], so that a lattice of the same cells fits the
image at any scale. Cells and vertices are numbered row by row. */
class Lattice
{
public:
    Lattice() = default;
    Lattice(Size image_size, int cols, int rows);

    int cols() const { return cols_; }
    int rows() const { return rows_; }
    int cellCount() const { return cols_ * rows_; }
    int vertexCount() const { return (cols_ + 1) * (rows_ + 1); }
    Size imageSize() const { return image_size_; }
    Size2d cellSize() const { return cell_size_; }

    /// Index of corner 0..3 of a cell.
    int vertexOf(int cell, int corner) const
    {
        return (cell / cols_ + (corner >> 1)) * (cols_ + 1) + cell % cols_ + (corner & 1);
    }

    /// Position of a vertex, reference pixels.
    Point2d referenceVertex(int vertex) const;

    /// Position of a cell point, reference pixels.
    Point2d referencePoint(const CellPoint& point) const;

    bool contains(Point2d reference_px) const;

    /// Cell and weights of a reference point. Outside the lattice the nearest cell extrapolates: weights may be negative.
    CellPoint locate(Point2d reference_px) const;

    /// The cells that share a side or a corner with this one, in ascending order; returns how many (3, 5 or 8).
    int neighbours(int cell, std::array<int, 8>& out) const;

private:
    Size image_size_;
    int cols_ = 0;
    int rows_ = 0;
    Size2d cell_size_;
};

/// Bilinear weights of the fractions (u, v) in a cell, in corner order.
inline std::array<double, 4> bilinearWeights(double u, double v)
{
    return {{(1 - u) * (1 - v), u * (1 - v), (1 - u) * v, u * v}};
}

// Called for every sample of every overlap, so inline.
inline bool Lattice::contains(Point2d reference_px) const
{
    return reference_px.x >= -0.5 && reference_px.y >= -0.5 && reference_px.x <= image_size_.width - 0.5 &&
           reference_px.y <= image_size_.height - 0.5;
}

inline CellPoint Lattice::locate(Point2d reference_px) const
{
    const double x = (reference_px.x + 0.5) / cell_size_.width;
    const double y = (reference_px.y + 0.5) / cell_size_.height;
    // Bounded before the cast, and in this order: NaN becomes 0.
    const int col = static_cast<int>(std::min(std::max(0.0, std::floor(x)), cols_ - 1.0));
    const int row = static_cast<int>(std::min(std::max(0.0, std::floor(y)), rows_ - 1.0));
    CellPoint point;
    point.cell = row * cols_ + col;
    point.weight = bilinearWeights(x - col, y - row);
    return point;
}

} // namespace gcpw
} // namespace cv

#endif
