// Part of the GCPW module for OpenCV. Licence: Apache-2.0 (see LICENSE).
#include "rendering/color_field.hpp"

#include <algorithm>

namespace cv
{
namespace gcpw
{

namespace
{

const int STEP = 8; ///< px between the nodes on which the colour map is evaluated

typedef Vec<float, 6> GridValue;   ///< gains, then biases, of Y, Cr, Cb
typedef Vec<float, 12> ColorMap;   ///< rows of a 3 x 4 matrix on (B, G, R, 1) in 0..255

GridValue readGrid(const Mat& grid, double x, double y)
{
    x = std::min(std::max(0.0, x - 0.5), grid.cols - 1.0); // in this order NaN becomes 0
    y = std::min(std::max(0.0, y - 0.5), grid.rows - 1.0);
    const int col = std::min(static_cast<int>(x), std::max(grid.cols - 2, 0));
    const int row = std::min(static_cast<int>(y), std::max(grid.rows - 2, 0));
    const int right = std::min(col + 1, grid.cols - 1);
    const int below = std::min(row + 1, grid.rows - 1);
    const float u = static_cast<float>(x - col);
    const float v = static_cast<float>(y - row);
    const GridValue top = grid.at<GridValue>(row, col) * (1 - u) + grid.at<GridValue>(row, right) * u;
    const GridValue bottom = grid.at<GridValue>(below, col) * (1 - u) + grid.at<GridValue>(below, right) * u;
    return top * (1 - v) + bottom * v;
}

/// YCrCb as cv::cvtColor has it, without the offset of Cr and Cb, which `offset` puts back.
const Matx33d YCRCB_FROM_BGR(0.114, 0.587, 0.299, -0.114 * 0.713, -0.587 * 0.713, (1 - 0.299) * 0.713, (1 - 0.114) * 0.564,
                             -0.587 * 0.564, -0.299 * 0.564);
const Vec3d OFFSET(0, 0.5, 0.5);

ColorMap bgrMap(const GridValue& value, const Matx33d& bgr_from_ycrcb)
{
    // gain * (T c + o) + bias = o + T c',  so  c' = T^-1 (gain T c + (gain - 1) o + bias)
    const Vec3d gain(value[0], value[1], value[2]);
    const Vec3d bias(value[3], value[4], value[5]);
    const Matx33d linear = bgr_from_ycrcb * Matx33d::diag(gain) * YCRCB_FROM_BGR;
    const Vec3d shift = 255 * (bgr_from_ycrcb * ((gain - Vec3d::all(1)).mul(OFFSET) + bias));
    ColorMap map;
    for (int r = 0; r < 3; ++r)
    {
        for (int c = 0; c < 3; ++c)
            map[4 * r + c] = static_cast<float>(linear(r, c));
        map[4 * r + 3] = static_cast<float>(shift[r]);
    }
    return map;
}

void mapPixel(const ColorMap& m, Vec3b& p)
{
    const float b = p[0];
    const float g = p[1];
    const float r = p[2];
    p = Vec3b(saturate_cast<uchar>(m[0] * b + m[1] * g + m[2] * r + m[3]),
              saturate_cast<uchar>(m[4] * b + m[5] * g + m[6] * r + m[7]),
              saturate_cast<uchar>(m[8] * b + m[9] * g + m[10] * r + m[11]));
}

/// A gray pixel is a colour without hue: what the map makes of it is gray again only as far as Y says.
void mapPixel(const ColorMap& m, uchar& p)
{
    const float b = (m[0] + m[1] + m[2]) * p + m[3];
    const float g = (m[4] + m[5] + m[6]) * p + m[7];
    const float r = (m[8] + m[9] + m[10]) * p + m[11];
    p = saturate_cast<uchar>(0.114F * b + 0.587F * g + 0.299F * r);
}

template <typename Pixel>
void mapRows(Mat& picture, const Mat& nodes, const Range& rows)
{
    for (int y = rows.start; y < rows.end; ++y)
    {
        const int row = y / STEP;
        const float v = static_cast<float>(y - row * STEP) / STEP;
        for (int col = 0; col * STEP < picture.cols; ++col)
        {
            ColorMap map = nodes.at<ColorMap>(row, col) * (1 - v) + nodes.at<ColorMap>(row + 1, col) * v;
            const ColorMap end = nodes.at<ColorMap>(row, col + 1) * (1 - v) + nodes.at<ColorMap>(row + 1, col + 1) * v;
            const ColorMap slope = (end - map) * (1.0F / STEP);
            Pixel* pixel = picture.ptr<Pixel>(y) + col * STEP;
            const int count = std::min(STEP, picture.cols - col * STEP);
            for (int i = 0; i < count; ++i, map += slope)
                mapPixel(map, pixel[i]);
        }
    }
}

} // namespace

void correctPicture(Mat& picture, const Mat& color, const std::function<Point2d(Point2d)>& grid_at)
{
    CV_CheckType(picture.type(), picture.type() == CV_8UC3 || picture.type() == CV_8UC1, "gcpw: colours are corrected in 8-bit BGR or gray");
    CV_CheckTypeEQ(color.type(), CV_32FC(6), "gcpw: a colour grid has gain and bias of Y, Cr, Cb");
    const Matx33d bgr_from_ycrcb = YCRCB_FROM_BGR.inv();
    Mat nodes(picture.rows / STEP + 2, picture.cols / STEP + 2, CV_32FC(12));
    for (int row = 0; row < nodes.rows; ++row)
        for (int col = 0; col < nodes.cols; ++col)
        {
            const Point2d at = grid_at(Point2d(col * STEP, row * STEP));
            nodes.at<ColorMap>(row, col) = bgrMap(readGrid(color, at.x, at.y), bgr_from_ycrcb);
        }
    parallel_for_(Range(0, picture.rows), [&](const Range& rows)
    {
        if (picture.channels() == 3)
            mapRows<Vec3b>(picture, nodes, rows);
        else
            mapRows<uchar>(picture, nodes, rows);
    });
}

} // namespace gcpw
} // namespace cv
