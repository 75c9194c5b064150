// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#include "common/crop.hpp"

RectangleSearch::RectangleSearch(int width) : heights_(static_cast<size_t>(width) + 1, 0) {}

void RectangleSearch::add(const cv::Mat& shown)
{
    const int width = static_cast<int>(heights_.size()) - 1;
    CV_Assert(shown.type() == CV_8UC1 && shown.cols == width);
    // Each row is a histogram of how many pixels are shown without a gap above it; its largest rectangle ends in this row.
    struct Bar
    {
        int left;
        int height;
    };
    std::vector<Bar> open; // of rising height
    for (int y = 0; y < shown.rows; ++y, ++rows_)
    {
        const uchar* const row = shown.ptr<uchar>(y);
        open.clear();
        for (int x = 0; x <= width; ++x)
        {
            int& height = heights_[static_cast<size_t>(x)];
            if (x < width) // the last one stays 0 and closes all bars
                height = row[x] ? height + 1 : 0;
            int left = x;
            while (!open.empty() && open.back().height >= height)
            {
                const Bar bar = open.back();
                open.pop_back();
                left = bar.left;
                if (static_cast<int64>(bar.height) * (x - left) > static_cast<int64>(best_.width) * best_.height)
                    best_ = cv::Rect(left, rows_ - bar.height + 1, x - left, bar.height);
            }
            if (height > 0)
                open.push_back({left, height});
        }
    }
}

cv::Rect largestRectangle(const cv::Mat& shown)
{
    if (shown.empty())
        return {};
    RectangleSearch search(shown.cols);
    search.add(shown);
    return search.best();
}
