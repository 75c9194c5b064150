// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#ifndef GCPW_APPS_MATCH_LOG_HPP
#define GCPW_APPS_MATCH_LOG_HPP

#include <functional>
#include <map>
#include <mutex>
#include <string>
#include <utility>
#include <vector>
#include <opencv2/stitching/detail/matchers.hpp>

/** @brief What matchers find, pair by pair: for the progress, and for the graph of matches. From any thread. */
class MatchLog
{
public:
    /// @param images how many photographs there are
    explicit MatchLog(int images) : images_(images) {}

    /// @param show called with the share of pairs that are done
    void onPair(const std::function<void(double)>& show) { show_ = show; }

    void add(int a, int b, const cv::detail::MatchesInfo& info);

    /// The graph in the DOT language, as stitching_detailed writes it. @param names of the photographs
    std::string graph(const std::vector<std::string>& names, double confidence) const;

private:
    int images_;
    std::function<void(double)> show_;
    mutable std::mutex mutex_;
    int calls_ = 0;
    std::map<std::pair<int, int>, cv::detail::MatchesInfo> best_; ///< of each pair, the most inliers
};

#endif
