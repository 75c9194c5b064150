// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#ifndef OPENCV_GCPW_CROSS_MATRIX_HPP
#define OPENCV_GCPW_CROSS_MATRIX_HPP

#include <vector>
#include <Eigen/Core>
#include "solver/normal_equations.hpp"
#include "geometry/lattice.hpp"

namespace cv
{
namespace gcpw
{

/** @brief What ties the vertices of two meshes that both move: the off-diagonal block of their normal equations.

Accumulated as 8 x 8 blocks between a quad of one mesh and a quad of the other. Quads share vertices, so most of those blocks
meet in the same entries: the sum is kept as 2 x 2 blocks between vertices, a fifth of the numbers. */
class CrossMatrix
{
public:
    /// @param rows, cols lattices of the two meshes
    CrossMatrix(const Lattice& rows, const Lattice& cols);

    void setZero();
    void add(int row_cell, int col_cell, const QuadBlock& block);

    /// out += matrix * in
    void multiply(const Eigen::Ref<const Eigen::VectorXd>& in, Eigen::Ref<Eigen::VectorXd> out) const;
    /// out += matrix^T * in
    void multiplyTransposed(const Eigen::Ref<const Eigen::VectorXd>& in, Eigen::Ref<Eigen::VectorXd> out) const;

private:
    struct Entry
    {
        int col; ///< vertex
        Eigen::Matrix2d block;
    };
    Lattice rows_;
    Lattice cols_;
    std::vector<std::vector<Entry>> entries_; ///< by row vertex
};

} // namespace gcpw
} // namespace cv

#endif
