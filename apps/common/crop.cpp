// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#include "common/crop.hpp"

#include <vector>

cv::Rect largestRectangle(const cv::Mat& shown)
{
    CV_Assert(shown.empty() || shown.type() == CV_8UC1);
    // Each row is a histogram of how many pixels are shown without a gap above it; its largest rectangle ends in this row.
    struct Bar
    {
        int left;
        int height;
    };
    cv::Rect best;
    std::vector<int> heights(static_cast<size_t>(shown.cols) + 1, 0); // the last one stays 0 and closes all bars
    std::vector<Bar> open;                                            // of rising height
    for (int y = 0; y < shown.rows; ++y)
    {
        const uchar* const row = shown.ptr<uchar>(y);
        open.clear();
        for (int x = 0; x <= shown.cols; ++x)
        {
            if (x < shown.cols)
                heights[x] = row[x] ? heights[x] + 1 : 0;
            int left = x;
            while (!open.empty() && open.back().height >= heights[x])
            {
                const Bar bar = open.back();
                open.pop_back();
                left = bar.left;
                if (static_cast<int64>(bar.height) * (x - left) > static_cast<int64>(best.width) * best.height)
                    best = cv::Rect(left, y - bar.height + 1, x - left, bar.height);
            }
            if (heights[x] > 0)
                open.push_back({left, heights[x]});
        }
    }
    return best;
}
