// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#include "stitch/counted_seams.hpp"

#include <opencv2/stitching/detail/util.hpp>

void CountedSeams::find(const std::vector<cv::UMat>& src, const std::vector<cv::Point>& corners,
                        std::vector<cv::UMat>& masks)
{
    pairs_ = done_ = 0;
    cv::Rect roi;
    for (size_t i = 0; i < src.size() && src.size() == corners.size(); ++i)
        for (size_t j = i + 1; j < src.size(); ++j)
            pairs_ += cv::detail::overlapRoi(corners[i], corners[j], src[i].size(), src[j].size(), roi) ? 1 : 0;
    GcpwSeamFinder::find(src, corners, masks);
}

void CountedSeams::findInPair(size_t first, size_t second, cv::Rect roi)
{
    GcpwSeamFinder::findInPair(first, second, roi);
    ++done_;
    show_(static_cast<double>(done_) / static_cast<double>(std::max(pairs_, done_)));
}
