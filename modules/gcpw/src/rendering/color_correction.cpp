// Part of the GCPW module for OpenCV. Licence: Apache-2.0 (see LICENSE).
#include "rendering/color_correction.hpp"

#include <algorithm>
#include <opencv2/imgproc.hpp>
#include "model/color_grid.hpp"

namespace cv
{
namespace gcpw
{

namespace
{

typedef Vec<float, 2 * CHANNELS> GridValue; ///< gains, then biases

/// Bilinear between the four nearest quad centres, constant beyond the outer ones; (x, y) in quads.
GridValue readGrid(const Mat& grid, float x, float y)
{
    x = std::min(std::max(x, 0.0F), static_cast<float>(grid.cols - 1));
    y = std::min(std::max(y, 0.0F), static_cast<float>(grid.rows - 1));
    const int col = std::min(static_cast<int>(x), std::max(grid.cols - 2, 0));
    const int row = std::min(static_cast<int>(y), std::max(grid.rows - 2, 0));
    const int right = std::min(col + 1, grid.cols - 1);
    const int below = std::min(row + 1, grid.rows - 1);
    const float u = x - static_cast<float>(col);
    const float v = y - static_cast<float>(row);
    const GridValue top = grid.at<GridValue>(row, col) * (1 - u) + grid.at<GridValue>(row, right) * u;
    const GridValue bottom = grid.at<GridValue>(below, col) * (1 - u) + grid.at<GridValue>(below, right) * u;
    return top * (1 - v) + bottom * v;
}

} // namespace

Mat correctColors(const Mat& bgr, const Mat& position, const Mat& mask, const Mat& color, Size reference_size)
{
    CV_Assert(position.size() == bgr.size() && mask.size() == bgr.size() && color.type() == CV_32FC(2 * CHANNELS));
    Mat result = bgr.clone();
    const float sx = static_cast<float>(color.cols) / static_cast<float>(reference_size.width);
    const float sy = static_cast<float>(color.rows) / static_cast<float>(reference_size.height);
    // In stripes: the floating-point copy of a whole panorama would take four times its memory.
    const int stripe_height = 32;
    parallel_for_(Range(0, (bgr.rows + stripe_height - 1) / stripe_height), [&](const Range& range)
    {
        for (int stripe = range.start; stripe < range.end; ++stripe)
        {
            const Range rows(stripe * stripe_height, std::min((stripe + 1) * stripe_height, bgr.rows));
            Mat pixels;
            bgr.rowRange(rows).convertTo(pixels, CV_32F, 1.0 / 255.0);
            cvtColor(pixels, pixels, COLOR_BGR2YCrCb);
            for (int y = 0; y < pixels.rows; ++y)
                for (int x = 0; x < pixels.cols; ++x)
                {
                    const Vec2f& p = position.at<Vec2f>(rows.start + y, x);
                    const GridValue map = readGrid(color, (p[0] + 0.5F) * sx - 0.5F, (p[1] + 0.5F) * sy - 0.5F);
                    Vec3f& pixel = pixels.at<Vec3f>(y, x);
                    for (int c = 0; c < CHANNELS; ++c)
                        pixel[c] = map[c] * pixel[c] + map[CHANNELS + c];
                }
            cvtColor(pixels, pixels, COLOR_YCrCb2BGR);
            Mat bytes;
            pixels.convertTo(bytes, CV_8U, 255.0);
            bytes.copyTo(result.rowRange(rows), mask.rowRange(rows));
        }
    });
    return result;
}

} // namespace gcpw
} // namespace cv
