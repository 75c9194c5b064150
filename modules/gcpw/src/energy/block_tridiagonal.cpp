// Part of the GCPW module for OpenCV. Licence: Apache-2.0 (see LICENSE).
#include "energy/block_tridiagonal.hpp"

#include <Eigen/Cholesky>

namespace cv
{
namespace gcpw
{

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
            block.selfadjointView<Eigen::Lower>().rankUpdate(below_[k - 1], -1.0);
        const Eigen::LLT<Eigen::Ref<Eigen::MatrixXd>> in_place(block);
        if (in_place.info() != Eigen::Success || !block.diagonal().allFinite())
            return false;
        if (k + 1 < blocks())
            block.triangularView<Eigen::Lower>().transpose().solveInPlace<Eigen::OnTheRight>(below_[k]);
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
