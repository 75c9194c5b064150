// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#include "solver/block_tridiagonal.hpp"

#include <algorithm>
#include <Eigen/Cholesky>

namespace cv
{
namespace gcpw
{

namespace
{

const int STRIPS = 5; ///< of rows; more strips save more zeros but make smaller products

/// The first column in which a strip of rows of a lower block, or of its product with L^-T, is not zero.
int firstColumn(const Eigen::MatrixXd& below, int row, int rows)
{
    int first = static_cast<int>(below.cols());
    for (int i = row; i < row + rows; ++i)
        for (int j = 0; j < first; ++j)
            if (below(i, j) != 0)
                first = j;
    return first;
}

struct Strip
{
    int row;
    int rows;
    int first; ///< column
};

std::vector<Strip> stripsOf(const Eigen::MatrixXd& below)
{
    std::vector<Strip> strips;
    const int n = static_cast<int>(below.rows());
    for (int k = 0; k < STRIPS; ++k)
    {
        const int row = n * k / STRIPS;
        const int rows = n * (k + 1) / STRIPS - row;
        if (rows > 0)
            strips.push_back({row, rows, firstColumn(below, row, rows)});
    }
    return strips;
}

/// below = below L^-T. L^-T is upper triangular, so a strip stays zero left of its first column.
void solveRight(const Eigen::Ref<const Eigen::MatrixXd>& lower, Eigen::MatrixXd& below)
{
    for (const Strip& s : stripsOf(below))
    {
        const int width = static_cast<int>(below.cols()) - s.first;
        auto part = below.block(s.row, s.first, s.rows, width);
        lower.bottomRightCorner(width, width).triangularView<Eigen::Lower>().transpose().solveInPlace<Eigen::OnTheRight>(part);
    }
}

/// Lower triangle of block -= below below^T.
void subtractProduct(const Eigen::MatrixXd& below, Eigen::Ref<Eigen::MatrixXd> block)
{
    const std::vector<Strip> strips = stripsOf(below);
    for (size_t i = 0; i < strips.size(); ++i)
        for (size_t j = 0; j <= i; ++j)
        {
            const Strip& p = strips[i];
            const Strip& q = strips[j];
            const int first = std::max(p.first, q.first);
            const int width = static_cast<int>(below.cols()) - first;
            block.block(p.row, q.row, p.rows, q.rows).noalias() -=
                below.block(p.row, first, p.rows, width) * below.block(q.row, first, q.rows, width).transpose();
        }
}

} // namespace

BlockTridiagonal::BlockTridiagonal(int blocks, int block_size)
    : block_size_(block_size), diagonal_(blocks, Eigen::MatrixXd::Zero(block_size, block_size)),
      below_(blocks - 1, Eigen::MatrixXd::Zero(block_size, block_size))
{
}

void BlockTridiagonal::setZero()
{
    for (auto& block : diagonal_)
        block.setZero();
    for (auto& block : below_)
        block.setZero();
}

bool BlockTridiagonal::factorize()
{
    for (int k = 0; k < blocks(); ++k)
    {
        Eigen::Ref<Eigen::MatrixXd> block(diagonal_[k]);
        if (k > 0)
            subtractProduct(below_[k - 1], block);
        const Eigen::LLT<Eigen::Ref<Eigen::MatrixXd>> in_place(block);
        if (in_place.info() != Eigen::Success || !block.diagonal().allFinite())
            return false;
        if (k + 1 < blocks())
            solveRight(block, below_[k]);
    }
    return true;
}

void BlockTridiagonal::solve(Eigen::Ref<Eigen::VectorXd> x) const
{
    const int n = block_size_;
    for (int k = 0; k < blocks(); ++k)
    {
        if (k > 0)
            x.segment(k * n, n).noalias() -= below_[k - 1] * x.segment((k - 1) * n, n);
        auto part = x.segment(k * n, n);
        diagonal_[k].triangularView<Eigen::Lower>().solveInPlace(part);
    }
    for (int k = blocks() - 1; k >= 0; --k)
    {
        if (k + 1 < blocks())
            x.segment(k * n, n).noalias() -= below_[k].transpose() * x.segment((k + 1) * n, n);
        auto part = x.segment(k * n, n);
        diagonal_[k].triangularView<Eigen::Lower>().transpose().solveInPlace(part);
    }
}

} // namespace gcpw
} // namespace cv
