// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#include "solver/low_rank.hpp"

namespace cv
{
namespace gcpw
{

void LowRank::clear()
{
    entries_.clear();
    ends_.clear();
}

void LowRank::add(const SparseColumn& column, double factor)
{
    for (const SparseEntry& entry : column)
        entries_.push_back({entry.index, factor * entry.value});
    ends_.push_back(entries_.size());
}

void LowRank::subtractProduct(const Eigen::Ref<const Eigen::VectorXd>& in, Eigen::Ref<Eigen::VectorXd> out) const
{
    size_t begin = 0;
    for (const size_t end : ends_)
    {
        double sum = 0;
        for (size_t k = begin; k < end; ++k)
            sum += entries_[k].value * in[entries_[k].index];
        for (size_t k = begin; k < end; ++k)
            out[entries_[k].index] -= entries_[k].value * sum;
        begin = end;
    }
}

} // namespace gcpw
} // namespace cv
