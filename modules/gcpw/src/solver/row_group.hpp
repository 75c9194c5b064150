// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#ifndef OPENCV_GCPW_ROW_GROUP_HPP
#define OPENCV_GCPW_ROW_GROUP_HPP

#include <array>
#include <vector>
#include "geometry/lattice.hpp"
#include "solver/low_rank.hpp"

namespace cv
{
namespace gcpw
{

/// A row of the Jacobian over the eight coordinates of a quad's corners: x0, y0, x1, .. y3.
typedef std::array<double, 8> QuadRow;

/// One of many rows of an image that share two unknowns of their own.
struct GroupRow
{
    int cell = -1;
    QuadRow row{};
    std::array<double, 2> shared{}; ///< how the residual depends on the unknowns that the rows share
};

/** @brief Rows of one image that share two unknowns z of their own: residual_k + row_k . d + shared_k . z, the least over z.

The unknowns are eliminated exactly (variable projection), so that a group does not resist what they can follow. What that takes
depends on the rows alone and is found once. */
class RowGroup
{
public:
    RowGroup(const Lattice& lattice, const std::vector<GroupRow>& rows);

    const std::vector<GroupRow>& rows() const { return rows_; }

    /** @brief Takes out of residuals, one for each row, what the unknowns can follow.
    @return the sum of squares that is left */
    double project(std::vector<double>& residuals) const;

    /** @brief The columns u of what the unknowns take off the normal matrix of the rows, which is sum_k row_k row_k^T - sum u u^T.

    Indices are 2 * vertex + axis; none to two columns. */
    const std::vector<SparseColumn>& followed() const { return followed_; }

private:
    std::vector<GroupRow> rows_;
    std::vector<std::vector<double>> basis_; ///< orthonormal, over the rows: what the unknowns can follow
    std::vector<SparseColumn> followed_;
};

} // namespace gcpw
} // namespace cv

#endif
