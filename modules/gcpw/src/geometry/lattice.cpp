// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#include "geometry/lattice.hpp"

#include <algorithm>
#include <cmath>

namespace cv
{
namespace gcpw
{

Lattice::Lattice(Size image_size, int cols, int rows)
    : image_size_(image_size), cols_(cols), rows_(rows),
      cell_size_(static_cast<double>(image_size.width) / cols, static_cast<double>(image_size.height) / rows)
{
    CV_CheckGT(image_size.width, 0, "A lattice needs an image that is not empty");
    CV_CheckGT(image_size.height, 0, "A lattice needs an image that is not empty");
    CV_CheckGT(cols, 0, "A lattice needs at least one column of cells");
    CV_CheckGT(rows, 0, "A lattice needs at least one row of cells");
}

Point2d Lattice::referenceVertex(int vertex) const
{
    const int col = vertex % (cols_ + 1);
    const int row = vertex / (cols_ + 1);
    return {col * cell_size_.width - 0.5, row * cell_size_.height - 0.5};
}

Point2d Lattice::referencePoint(const CellPoint& point) const
{
    const double u = point.weight[1] + point.weight[3];
    const double v = point.weight[2] + point.weight[3];
    const int col = point.cell % cols_;
    const int row = point.cell / cols_;
    return {(col + u) * cell_size_.width - 0.5, (row + v) * cell_size_.height - 0.5};
}

int Lattice::neighbours(int cell, std::array<int, 8>& out) const
{
    const int col = cell % cols_;
    const int row = cell / cols_;
    int count = 0;
    for (int r = std::max(row - 1, 0); r <= std::min(row + 1, rows_ - 1); ++r)
        for (int c = std::max(col - 1, 0); c <= std::min(col + 1, cols_ - 1); ++c)
            if (r != row || c != col)
                out[count++] = r * cols_ + c;
    return count;
}

} // namespace gcpw
} // namespace cv
