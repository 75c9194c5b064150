// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#include "rendering/color_field.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <opencv2/core/hal/intrin.hpp>

namespace cv
{
namespace gcpw
{

namespace
{

typedef Vec<float, 6> GridValue; ///< gains, then biases, of Y, Cr, Cb
typedef ColorField::ColorMap ColorMap;

const int STEP = 8;           ///< px between positions; meshes bend over tens of pixels
const int SPAN = 32;          ///< px between maps, at most
const int LANES = 16;         ///< px that are mapped at once
const float MAX_TWIST = 0.04F; ///< quads^2: a bilinear map along a slanted row is off its chord by a quarter of this times its mixed difference

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

/// Of 16 bits, which are 8 bits 257 times: the map's shift is in those.
void mapPixel(const ColorMap& m, Vec3w& p)
{
    const float shift = 257;
    const float b = p[0];
    const float g = p[1];
    const float r = p[2];
    p = Vec3w(saturate_cast<ushort>(m[0] * b + m[1] * g + m[2] * r + m[3] * shift),
              saturate_cast<ushort>(m[4] * b + m[5] * g + m[6] * r + m[7] * shift),
              saturate_cast<ushort>(m[8] * b + m[9] * g + m[10] * r + m[11] * shift));
}

/// A gray pixel is a colour without hue: what the map makes of it is gray again only as far as Y says.
void mapPixel(const ColorMap& m, uchar& p)
{
    const float b = (m[0] + m[1] + m[2]) * p + m[3];
    const float g = (m[4] + m[5] + m[6]) * p + m[7];
    const float r = (m[8] + m[9] + m[10]) * p + m[11];
    p = saturate_cast<uchar>(0.114F * b + 0.587F * g + 0.299F * r);
}

/// Maps pixels along a row, count <= SPAN; the map of pixel k is map + k * slope.
template <typename Pixel>
void mapPixels(ColorMap map, const ColorMap& slope, Pixel* pixels, int count)
{
    for (int k = 0; k < count; ++k, map += slope)
        mapPixel(map, pixels[k]);
}

/// The lower or the upper half of eight numbers.
v_float32x4 half(const v_uint16x8& numbers, int which)
{
    v_uint32x4 low;
    v_uint32x4 high;
    v_expand(numbers, low, high);
    return v_cvt_f32(v_reinterpret_as_s32(which == 0 ? low : high));
}

/// Up to LANES pixels. The maps are those of four pixels, and taken to those of the next.
void mapLanes(v_float32x4 (&maps)[12], const v_float32x4 (&steps)[12], Vec3b* pixels, int count)
{
    uchar buffer[3 * LANES] = {};
    uchar* bytes = pixels->val;
    if (count < LANES)
    {
        std::memcpy(buffer, bytes, 3 * static_cast<size_t>(count));
        bytes = buffer;
    }
    v_uint8x16 bgr[3];
    v_load_deinterleave(bytes, bgr[0], bgr[1], bgr[2]);
    v_uint16x8 wide[3][2];
    for (int c = 0; c < 3; ++c)
        v_expand(bgr[c], wide[c][0], wide[c][1]);
    v_int32x4 mapped[3][LANES / 4];
    for (auto& channel : mapped)
        std::fill(channel, channel + LANES / 4, v_setzero_s32());
    for (int q = 0; 4 * q < count; ++q)
    {
        const v_float32x4 b = half(wide[0][q / 2], q % 2);
        const v_float32x4 g = half(wide[1][q / 2], q % 2);
        const v_float32x4 r = half(wide[2][q / 2], q % 2);
        for (int c = 0; c < 3; ++c)
            mapped[c][q] = v_round(maps[4 * c] * b + maps[4 * c + 1] * g + maps[4 * c + 2] * r + maps[4 * c + 3]);
        for (int m = 0; m < 12; ++m)
            maps[m] += steps[m];
    }
    for (int c = 0; c < 3; ++c)
        bgr[c] = v_pack_u(v_pack(mapped[c][0], mapped[c][1]), v_pack(mapped[c][2], mapped[c][3]));
    v_store_interleave(bytes, bgr[0], bgr[1], bgr[2]);
    if (count < LANES)
        std::memcpy(pixels->val, buffer, 3 * static_cast<size_t>(count));
}

void mapPixels(const ColorMap& map, const ColorMap& slope, Vec3b* pixels, int count)
{
    v_float32x4 maps[12];
    v_float32x4 steps[12];
    for (int m = 0; m < 12; ++m)
    {
        maps[m] = v_setall_f32(map[m]) + v_float32x4(0, 1, 2, 3) * v_setall_f32(slope[m]);
        steps[m] = v_setall_f32(4 * slope[m]);
    }
    for (int k = 0; k < count; k += LANES)
        mapLanes(maps, steps, pixels + k, std::min(LANES, count - k));
}

/// Between which quad centres a point lies; -1 and the last one are beyond the outer centres. NaN counts as 0.
int spanOf(float quads, int count)
{
    return static_cast<int>(std::floor(std::min(std::max(-1.0F, quads - 0.5F), count - 1.0F)));
}

/// One row of a picture on its field.
template <typename Pixel>
class Row
{
public:
    Row(Mat& picture, int y, const ColorField& field, Size grid, const GridPosition& position)
        : pixels_(picture.ptr<Pixel>(y)), y_(y), field_(field), grid_(grid), position_(position)
    {
    }

    /// Maps the pixels first..last, which all have a position.
    void map(int first, int last)
    {
        Knot from = knotAt(first);
        while (from.x < last)
        {
            // At whole steps, so that neither a mask nor a thread moves the knots.
            const Knot to = knotAt(std::min((from.x / SPAN + 1) * SPAN, last));
            mapSpan(from, to);
            from = to;
        }
        mapPixels(from.map, ColorMap(), pixels_ + last, 1);
    }

private:
    /// A pixel on which the map was read.
    struct Knot
    {
        int x;
        Point2f at;
        Point cell; ///< between which quad centres it lies
        ColorMap map;
    };

    Knot knotAt(int x) const
    {
        const Point2f at = position_(Point(x, y_));
        return {x, at, Point(spanOf(at.x, grid_.width), spanOf(at.y, grid_.height)), field_.at(at)};
    }

    /// Maps from.x up to the pixel before to.x.
    void mapSpan(const Knot& from, const Knot& to)
    {
        const int count = to.x - from.x;
        const Point2f along = to.at - from.at;
        const bool twisted = std::abs(along.x * along.y) > MAX_TWIST;
        const int part = twisted ? count / 2 : std::min({count, bend(from.at.x, along.x, from.cell.x, to.cell.x, count),
                                                         bend(from.at.y, along.y, from.cell.y, to.cell.y, count)});
        if (part > 0 && part < count)
        {
            const Knot middle = knotAt(from.x + part);
            mapSpan(from, middle);
            mapSpan(middle, to);
            return;
        }
        mapPixels(from.map, (to.map - from.map) * (1.0F / static_cast<float>(count)), pixels_ + from.x, count);
    }

    /// The last pixel before a way of some pixels passes a quad centre, at which the field bends, or the one behind it if that is the
    /// first one; their number if it passes none.
    /// @param at, along start and length of the way, quads
    static int bend(float at, float along, int cell, int last_cell, int count)
    {
        if (cell == last_cell)
            return count;
        const float centre = static_cast<float>(cell) + (last_cell > cell ? 1.5F : 0.5F);
        return std::max(1, cvFloor((centre - at) / along * static_cast<float>(count)));
    }

    Pixel* pixels_;
    int y_;
    const ColorField& field_;
    Size grid_;
    const GridPosition& position_;
};

/// Maps the pixels of row y inside the mask, run by run.
template <typename Pixel>
void mapRow(Row<Pixel> row, const uchar* mask, int cols)
{
    int x = 0;
    while (x < cols)
    {
        const int first = x;
        while (x < cols && (!mask || mask[x]))
            ++x;
        if (x > first)
            row.map(first, x - 1);
        else
            ++x;
    }
}

} // namespace

ColorField::ColorField(const Mat& color) : maps_(color.size(), CV_32FC(12))
{
    CV_CheckTypeEQ(color.type(), CV_32FC(6), "gcpw: a colour grid has gain and bias of Y, Cr, Cb");
    const Matx33d bgr_from_ycrcb = YCRCB_FROM_BGR.inv();
    for (int row = 0; row < color.rows; ++row)
        for (int col = 0; col < color.cols; ++col)
            maps_.at<ColorMap>(row, col) = bgrMap(color.at<GridValue>(row, col), bgr_from_ycrcb);
}

ColorMap ColorField::at(Point2f quads) const
{
    const float x = std::min(std::max(0.0F, quads.x - 0.5F), maps_.cols - 1.0F); // in this order NaN becomes 0
    const float y = std::min(std::max(0.0F, quads.y - 0.5F), maps_.rows - 1.0F);
    const int col = std::min(static_cast<int>(x), std::max(maps_.cols - 2, 0));
    const int row = std::min(static_cast<int>(y), std::max(maps_.rows - 2, 0));
    const int right = std::min(col + 1, maps_.cols - 1);
    const int below = std::min(row + 1, maps_.rows - 1);
    const float u = x - static_cast<float>(col);
    const float v = y - static_cast<float>(row);
    const float* top_left = maps_.ptr<float>(row, col);
    const float* top_right = maps_.ptr<float>(row, right);
    const float* low_left = maps_.ptr<float>(below, col);
    const float* low_right = maps_.ptr<float>(below, right);
    ColorMap map;
    for (int k = 0; k < ColorMap::channels; ++k)
    {
        const float top = top_left[k] * (1 - u) + top_right[k] * u;
        const float low = low_left[k] * (1 - u) + low_right[k] * u;
        map[k] = top * (1 - v) + low * v;
    }
    return map;
}

void ColorField::apply(Mat& picture, const Mat& mask, const GridPosition& position) const
{
    CV_CheckType(picture.type(), picture.type() == CV_8UC3 || picture.type() == CV_16UC3 || picture.type() == CV_8UC1,
                 "gcpw: colours are corrected in BGR of 8 or 16 bits, or gray of 8");
    CV_Assert(mask.empty() || (mask.type() == CV_8UC1 && mask.size() == picture.size()));
    parallel_for_(Range(0, picture.rows), [&](const Range& rows)
    {
        for (int y = rows.start; y < rows.end; ++y)
        {
            const uchar* inside = mask.empty() ? nullptr : mask.ptr<uchar>(y);
            if (picture.type() == CV_16UC3)
                mapRow(Row<Vec3w>(picture, y, *this, maps_.size(), position), inside, picture.cols);
            else if (picture.channels() == 3)
                mapRow(Row<Vec3b>(picture, y, *this, maps_.size(), position), inside, picture.cols);
            else
                mapRow(Row<uchar>(picture, y, *this, maps_.size(), position), inside, picture.cols);
        }
    });
}

GridPosition positionOnNodes(Size picture, const std::function<Point2d(Point2d)>& exact)
{
    Mat nodes(picture.height / STEP + 2, picture.width / STEP + 2, CV_32FC2);
    for (int row = 0; row < nodes.rows; ++row)
        for (int col = 0; col < nodes.cols; ++col)
        {
            const Point2d at = exact(Point2d(col * STEP, row * STEP));
            nodes.at<Vec2f>(row, col) = Vec2f(static_cast<float>(at.x), static_cast<float>(at.y));
        }
    return [nodes](Point pixel)
    {
        const int col = pixel.x / STEP;
        const int row = pixel.y / STEP;
        const float u = static_cast<float>(pixel.x - col * STEP) / STEP;
        const float v = static_cast<float>(pixel.y - row * STEP) / STEP;
        const Vec2f* top = nodes.ptr<Vec2f>(row) + col;
        const Vec2f* bottom = nodes.ptr<Vec2f>(row + 1) + col;
        const Vec2f at = (top[0] * (1 - u) + top[1] * u) * (1 - v) + (bottom[0] * (1 - u) + bottom[1] * u) * v;
        return Point2f(at[0], at[1]);
    };
}

} // namespace gcpw
} // namespace cv
