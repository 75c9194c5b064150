// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#include <gtest/gtest.h>
#include <opencv2/imgproc.hpp>
#include "common/crop.hpp"

namespace
{

/// The largest by trying all: for small pictures.
int largestArea(const cv::Mat& shown)
{
    int best = 0;
    for (int y = 0; y < shown.rows; ++y)
        for (int x = 0; x < shown.cols; ++x)
            for (int bottom = y + 1; bottom <= shown.rows; ++bottom)
                for (int right = x + 1; right <= shown.cols; ++right)
                {
                    const cv::Rect rect(x, y, right - x, bottom - y);
                    if (rect.area() > best && cv::countNonZero(shown(rect)) == rect.area())
                        best = rect.area();
                }
    return best;
}

TEST(Crop, no_rectangle_inside_is_larger)
{
    cv::RNG rng(5);
    for (int run = 0; run < 40; ++run)
    {
        cv::Mat shown(rng.uniform(1, 12), rng.uniform(1, 12), CV_8UC1);
        rng.fill(shown, cv::RNG::UNIFORM, 0, 256);
        shown = shown > rng.uniform(10, 150);
        const cv::Rect rect = largestRectangle(shown);
        EXPECT_EQ(rect.area(), largestArea(shown)) << shown;
        if (!rect.empty())
        {
            EXPECT_EQ(cv::countNonZero(shown(rect)), rect.area()) << shown;
        }
    }
}

TEST(Crop, the_whole_picture_and_none)
{
    EXPECT_EQ(largestRectangle(cv::Mat(30, 40, CV_8UC1, cv::Scalar(1))), cv::Rect(0, 0, 40, 30));
    EXPECT_TRUE(largestRectangle(cv::Mat::zeros(30, 40, CV_8UC1)).empty());
    EXPECT_TRUE(largestRectangle(cv::Mat()).empty());
}

} // namespace
