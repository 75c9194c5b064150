// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#include "stitch/match_log.hpp"

#include <algorithm>
#include <opencv2/stitching/detail/motion_estimators.hpp>

void MatchLog::add(int a, int b, const cv::detail::MatchesInfo& info)
{
    const std::lock_guard<std::mutex> lock(mutex_);
    cv::detail::MatchesInfo& best = best_[{a, b}];
    if (info.num_inliers >= best.num_inliers)
        best = info;
    const double pairs = 0.5 * images_ * (images_ - 1);
    if (show_)
        show_(std::min(1.0, ++calls_ / pairs));
}

std::string MatchLog::graph(const std::vector<std::string>& names, double confidence) const
{
    const std::lock_guard<std::mutex> lock(mutex_);
    const size_t count = names.size();
    std::vector<cv::detail::MatchesInfo> pairs(count * count);
    for (const auto& item : best_)
    {
        const auto a = static_cast<size_t>(item.first.first);
        const auto b = static_cast<size_t>(item.first.second);
        if (a < count && b < count)
            pairs[a * count + b] = pairs[b * count + a] = item.second;
    }
    std::vector<cv::String> paths(names.begin(), names.end());
    return cv::detail::matchesGraphAsString(paths, pairs, static_cast<float>(confidence));
}
