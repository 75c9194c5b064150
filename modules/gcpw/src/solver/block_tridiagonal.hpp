// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#ifndef OPENCV_GCPW_BLOCK_TRIDIAGONAL_HPP
#define OPENCV_GCPW_BLOCK_TRIDIAGONAL_HPP

#include <vector>
#include <Eigen/Core>

namespace cv
{
namespace gcpw
{

/** @brief A symmetric positive definite system whose blocks couple only with the next block.

A mesh is one: its vertex rows meet only the rows above and below. Dense factors of one row each are faster than a
general sparse factorisation of the same matrix, because nearly every entry of the band fills in. */
class BlockTridiagonal
{
public:
    BlockTridiagonal(int blocks, int block_size);

    void setZero();
    int blocks() const { return static_cast<int>(diagonal_.size()); }
    int blockSize() const { return block_size_; }

    /// Diagonal block k; only its lower triangle is read.
    Eigen::MatrixXd& diagonal(int k) { return diagonal_[k]; }
    /// Block (k + 1, k).
    Eigen::MatrixXd& below(int k) { return below_[k]; }

    /// Replaces the matrix by its Cholesky factor. False if it is not positive definite (or not finite).
    bool factorize();

    /// Solves in place; needs a successful factorize(). `x` has blocks() * blockSize() entries.
    void solve(Eigen::Ref<Eigen::VectorXd> x) const;

private:
    int block_size_;
    std::vector<Eigen::MatrixXd> diagonal_;
    std::vector<Eigen::MatrixXd> below_;
};

} // namespace gcpw
} // namespace cv

#endif
