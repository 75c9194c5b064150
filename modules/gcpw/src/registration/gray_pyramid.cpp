// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#include "registration/gray_pyramid.hpp"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>
#include "imaging/wide_vectors.hpp"

namespace cv
{
namespace gcpw
{

namespace
{

const int PADDING =
    WINDOW; ///< px around each level: a window half outside the image still has the image's border in it

/// Rows of bilinear values at one fraction of a pixel.
GCPW_WIDE_VECTORS void mixRows(const Mat& image, int col, int row, int ring, const float (&weight)[4],
                               WindowPixels& window)
{
    const int last = WINDOW + 1 + ring;
    for (int y = 1 - ring; y < last; ++y)
    {
        const float* top = image.ptr<float>(row + y) + col;
        const float* bottom = image.ptr<float>(row + y + 1) + col;
        float* out = window.value[y];
        for (int x = 0; x < WINDOW + 2; ++x)
            out[x] = weight[0] * top[x] + weight[1] * top[x + 1] + weight[2] * bottom[x] + weight[3] * bottom[x + 1];
    }
}

} // namespace

GrayPyramid::GrayPyramid(const Mat& gray, const Mat& mask, int levels) : size_(gray.size()), gray_(gray), mask_(mask)
{
    CV_Assert(gray.type() == CV_8UC1 && (mask.empty() || (mask.type() == CV_8UC1 && mask.size() == gray.size())));
    Mat level;
    gray.convertTo(level, CV_32F);
    while (static_cast<int>(padded_.size()) < levels && std::min(level.cols, level.rows) > PADDING)
    {
        Mat padded;
        copyMakeBorder(level, padded, PADDING, PADDING, PADDING, PADDING, BORDER_REFLECT_101);
        padded_.push_back(padded);
        Mat coarse;
        pyrDown(level, coarse);
        level = coarse;
    }
}

bool GrayPyramid::shows(Point2d image_px) const
{
    if (!(image_px.x >= 0 && image_px.y >= 0 && image_px.x <= size_.width - 1 && image_px.y <= size_.height - 1))
        return false;
    return mask_.empty() || mask_.at<uchar>(cvRound(image_px.y), cvRound(image_px.x)) != 0;
}

bool GrayPyramid::readUpright(const Mat& image, Point2d first, int ring, WindowPixels& window) const
{
    // Written so that NaN is refused too.
    if (!(first.x >= 0 && first.y >= 0 && first.x + WINDOW + 2 < image.cols - 1 &&
          first.y + WINDOW + 2 < image.rows - 1))
        return false;
    const int col = static_cast<int>(first.x);
    const int row = static_cast<int>(first.y);
    const float u = static_cast<float>(first.x - col);
    const float v = static_cast<float>(first.y - row);
    mixRows(image, col, row, ring, {(1 - u) * (1 - v), u * (1 - v), (1 - u) * v, u * v}, window);
    return true;
}

bool GrayPyramid::read(int level, Point2d centre, const Matx22d& step, int ring, WindowPixels& window) const
{
    const Mat& image = padded_[level];
    const double half = 0.5 * (WINDOW + 1);
    const Point2d middle = centre + Point2d(PADDING, PADDING);
    if (step == Matx22d::eye())
        return readUpright(image, middle - Point2d(half, half), ring, window);
    const Point2d along(step(0, 0), step(1, 0));
    const Point2d down(step(0, 1), step(1, 1));
    const double reach_x = half * (std::abs(along.x) + std::abs(down.x));
    const double reach_y = half * (std::abs(along.y) + std::abs(down.y));
    if (!(middle.x - reach_x >= 0 && middle.y - reach_y >= 0 && middle.x + reach_x < image.cols - 1 &&
          middle.y + reach_y < image.rows - 1))
        return false;
    for (int y = 1 - ring; y < WINDOW + 1 + ring; ++y)
    {
        Point2d p = middle + (y - half) * down - half * along;
        for (int x = 0; x < WINDOW + 2; ++x, p += along)
        {
            const int col = static_cast<int>(p.x);
            const int row = static_cast<int>(p.y);
            const float u = static_cast<float>(p.x - col);
            const float v = static_cast<float>(p.y - row);
            const float* top = image.ptr<float>(row) + col;
            const float* bottom = image.ptr<float>(row + 1) + col;
            const float upper = top[0] + u * (top[1] - top[0]);
            const float lower = bottom[0] + u * (bottom[1] - bottom[0]);
            window.value[y][x] = upper + v * (lower - upper);
        }
    }
    return true;
}

} // namespace gcpw
} // namespace cv
