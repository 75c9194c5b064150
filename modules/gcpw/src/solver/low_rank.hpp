// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#ifndef OPENCV_GCPW_LOW_RANK_HPP
#define OPENCV_GCPW_LOW_RANK_HPP

#include <vector>
#include <Eigen/Core>

namespace cv
{
namespace gcpw
{

/// A matrix U U^T of sparse columns.
class LowRank
{
public:
    void clear();
    bool empty() const { return ends_.empty(); }
    int rank() const { return static_cast<int>(ends_.size()); }

    void beginColumn() { begin_ = entries_.size(); }
    /// Several entries of one index are added up by endColumn().
    void add(int index, double value) { entries_.push_back({index, value}); }
    void endColumn();

    /// out -= U U^T in
    void subtractProduct(const Eigen::Ref<const Eigen::VectorXd>& in, Eigen::Ref<Eigen::VectorXd> out) const;

private:
    struct Entry
    {
        int index;
        double value;
    };
    std::vector<Entry> entries_;
    std::vector<size_t> ends_; ///< of every column in entries_
    size_t begin_ = 0;
};

} // namespace gcpw
} // namespace cv

#endif
