// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#include "solver/low_rank.hpp"

#include <algorithm>
#include <cstddef>

namespace cv
{
namespace gcpw
{

void LowRank::clear()
{
    entries_.clear();
    ends_.clear();
}

void LowRank::endColumn()
{
    const auto first = entries_.begin() + static_cast<std::ptrdiff_t>(begin_);
    std::stable_sort(first, entries_.end(), [](const Entry& a, const Entry& b) { return a.index < b.index; });
    auto last = first;
    for (auto entry = first; entry != entries_.end(); ++entry)
        if (entry != first && entry->index == last->index)
            last->value += entry->value;
        else
            *(entry == first ? last : ++last) = *entry;
    if (first != entries_.end())
        entries_.erase(last + 1, entries_.end());
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
