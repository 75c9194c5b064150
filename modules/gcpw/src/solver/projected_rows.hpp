// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#ifndef OPENCV_GCPW_PROJECTED_ROWS_HPP
#define OPENCV_GCPW_PROJECTED_ROWS_HPP

#include <vector>
#include "solver/normal_equations.hpp"

namespace cv
{
namespace gcpw
{

/// The rows of a group with what its own unknowns can follow taken out of their residuals.
struct ProjectedRows
{
    std::vector<double> residuals;
    std::vector<std::vector<double>> basis; ///< orthonormal, over the rows: what the unknowns can follow; none to two vectors
};

ProjectedRows projectOut(const std::vector<GroupRow>& rows);

} // namespace gcpw
} // namespace cv

#endif
