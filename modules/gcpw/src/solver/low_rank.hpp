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

struct SparseEntry
{
    int index;
    double value;
};

typedef std::vector<SparseEntry> SparseColumn; ///< each index at most once

/// A matrix U U^T of sparse columns.
class LowRank
{
public:
    void clear();
    bool empty() const { return ends_.empty(); }

    /// Adds the column factor * column to U.
    void add(const SparseColumn& column, double factor);

    /// out -= U U^T in
    void subtractProduct(const Eigen::Ref<const Eigen::VectorXd>& in, Eigen::Ref<Eigen::VectorXd> out) const;

private:
    SparseColumn entries_;     ///< of all columns, one after the other
    std::vector<size_t> ends_; ///< of every column in entries_
};

} // namespace gcpw
} // namespace cv

#endif
