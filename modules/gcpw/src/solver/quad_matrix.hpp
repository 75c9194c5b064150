// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#ifndef OPENCV_GCPW_QUAD_MATRIX_HPP
#define OPENCV_GCPW_QUAD_MATRIX_HPP

#include <vector>
#include "solver/block_tridiagonal.hpp"
#include "solver/normal_equations.hpp"
#include "geometry/lattice.hpp"

namespace cv
{
namespace gcpw
{

/** @brief Normal equations over the vertices of one mesh, kept as a sum of 8 x 8 quad blocks.

Column of a coordinate: 2 * vertex + axis. */
class QuadMatrix
{
public:
    explicit QuadMatrix(const Lattice& lattice);

    int size() const { return 2 * lattice_.vertexCount(); }
    int column(int cell, int k) const { return 2 * lattice_.vertexOf(cell, k >> 1) + (k & 1); }

    void setZero();
    void addRow(int cell, const QuadRow& row, double residual, double weight);
    void addBlock(int cell, const QuadBlock& block, const QuadRow& gradient);
    void addDiagonal(double weight) { diagonal_ += weight; }

    /// Factorises the sum; false if it is not positive definite.
    bool factorize();
    /// Solves in place with the factor.
    void solve(Eigen::Ref<Eigen::VectorXd> x) const { factor_.solve(x); }
    /// out += matrix * in
    void multiply(const Eigen::Ref<const Eigen::VectorXd>& in, Eigen::Ref<Eigen::VectorXd> out) const;
    /// out -= gradient
    void subtractGradient(Eigen::Ref<Eigen::VectorXd> out) const;

private:
    Lattice lattice_;
    std::vector<QuadBlock> blocks_;
    std::vector<QuadRow> gradients_;
    double diagonal_ = 0;
    BlockTridiagonal factor_;
};

} // namespace gcpw
} // namespace cv

#endif
