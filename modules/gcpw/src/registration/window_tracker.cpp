// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#include "registration/window_tracker.hpp"

#include <algorithm>
#include <cmath>
#include "imaging/wide_vectors.hpp"

namespace cv
{
namespace gcpw
{

namespace
{

const int MAX_STEPS = 8;             ///< of a level; few windows need more than five
const double FINE_ENOUGH = 0.03;     ///< px of a level: a shorter step ends it
const double MAX_DRIFT = WINDOW / 2; ///< px of a level: what moves farther has lost its window
const double LEAST_TEXTURE =
    1; ///< squared gray levels a px: the smaller eigenvalue of the mean gradient product; noise has as much
const double LEAST_VARIANCE = 1; ///< squared gray levels: below is rounding

/// Sums over the columns of a window, added up in one order with any vectors.
struct ColumnSums
{
    float value[WINDOW] = {};
    double total() const
    {
        double sum = 0;
        for (const float v : value)
            sum += v;
        return sum;
    }
};

/// The window to be found and how its residuals become a step.
struct Template
{
    float value[WINDOW][WINDOW];   ///< zero mean
    float slope_x[WINDOW][WINDOW]; ///< gradient, without its parts along 1 and value
    float slope_y[WINDOW][WINDOW];
    double squares = 0; ///< of value
    Matx22d products;   ///< sum of gradient products
    Matx22d inverse;    ///< of it, where isTextured()
};

GCPW_WIDE_VECTORS void takeWindow(const WindowPixels& w, Template& t)
{
    ColumnSums mean;
    ColumnSums mean_x;
    ColumnSums mean_y;
    for (int y = 0; y < WINDOW; ++y)
        for (int x = 0; x < WINDOW; ++x)
        {
            const float v = w.value[y + 1][x + 1];
            const float gx = 0.5F * (w.value[y + 1][x + 2] - w.value[y + 1][x]);
            const float gy = 0.5F * (w.value[y + 2][x + 1] - w.value[y][x + 1]);
            t.value[y][x] = v;
            t.slope_x[y][x] = gx;
            t.slope_y[y][x] = gy;
            mean.value[x] += v;
            mean_x.value[x] += gx;
            mean_y.value[x] += gy;
        }
    const double count = WINDOW * WINDOW;
    const float m = static_cast<float>(mean.total() / count);
    const float mx = static_cast<float>(mean_x.total() / count);
    const float my = static_cast<float>(mean_y.total() / count);
    ColumnSums vv;
    ColumnSums vx;
    ColumnSums vy;
    for (int y = 0; y < WINDOW; ++y)
        for (int x = 0; x < WINDOW; ++x)
        {
            const float v = t.value[y][x] -= m;
            const float gx = t.slope_x[y][x] -= mx;
            const float gy = t.slope_y[y][x] -= my;
            vv.value[x] += v * v;
            vx.value[x] += v * gx;
            vy.value[x] += v * gy;
        }
    t.squares = vv.total();
    const double scale = t.squares > 0 ? 1 / t.squares : 0;
    const float px = static_cast<float>(vx.total() * scale);
    const float py = static_cast<float>(vy.total() * scale);
    ColumnSums xx;
    ColumnSums xy;
    ColumnSums yy;
    for (int y = 0; y < WINDOW; ++y)
        for (int x = 0; x < WINDOW; ++x)
        {
            const float gx = t.slope_x[y][x] -= px * t.value[y][x];
            const float gy = t.slope_y[y][x] -= py * t.value[y][x];
            xx.value[x] += gx * gx;
            xy.value[x] += gx * gy;
            yy.value[x] += gy * gy;
        }
    t.products = Matx22d(xx.total(), xy.total(), xy.total(), yy.total());
}

/// Inverts the gradient products; false where the window has no texture in some direction.
bool isTextured(Template& t)
{
    const Matx22d& h = t.products;
    const double half_trace = 0.5 * (h(0, 0) + h(1, 1));
    const double determinant = h(0, 0) * h(1, 1) - h(0, 1) * h(0, 1);
    const double smaller = half_trace - std::sqrt(std::max(half_trace * half_trace - determinant, 0.0));
    if (!(smaller > LEAST_TEXTURE * WINDOW * WINDOW) || !(t.squares > LEAST_VARIANCE * WINDOW * WINDOW))
        return false;
    t.inverse = (1 / determinant) * Matx22d(h(1, 1), -h(0, 1), -h(0, 1), h(0, 0));
    return true;
}

/// How a window differs from the template.
struct Difference
{
    double slope_x = 0; ///< sum of value times slope
    double slope_y = 0;
    double product = 0;  ///< sum of both values
    double variance = 0; ///< of the window, times its pixels
};

GCPW_WIDE_VECTORS Difference compare(const Template& t, const WindowPixels& w)
{
    ColumnSums sx;
    ColumnSums sy;
    ColumnSums product;
    ColumnSums sum;
    ColumnSums squares;
    for (int y = 0; y < WINDOW; ++y)
        for (int x = 0; x < WINDOW; ++x)
        {
            const float v = w.value[y + 1][x + 1];
            sx.value[x] += v * t.slope_x[y][x];
            sy.value[x] += v * t.slope_y[y][x];
            product.value[x] += v * t.value[y][x];
            sum.value[x] += v;
            squares.value[x] += v * v;
        }
    Difference d;
    d.slope_x = sx.total();
    d.slope_y = sy.total();
    d.product = product.total();
    const double total = sum.total();
    d.variance = squares.total() - total * total / (WINDOW * WINDOW);
    return d;
}

enum class LevelEnd
{
    FOUND,
    LOST ///< no texture, beyond the image, or moved too far
};

/// On one level; `at` is the place in px of the level of b.
LevelEnd followOnLevel(const GrayPyramid& a, int level_a, Point2d from, const Matx22d& step, const GrayPyramid& b,
                       int level, Point2d& at, double& correlation)
{
    WindowPixels pixels;
    Template wanted;
    if (!a.read(level_a, from, step, 1, pixels))
        return LevelEnd::LOST;
    takeWindow(pixels, wanted);
    if (!isTextured(wanted))
        return LevelEnd::LOST;
    Point2d place = at;
    for (int k = 0;; ++k)
    {
        if (!b.read(level, place, Matx22d::eye(), 0, pixels))
            return LevelEnd::LOST;
        const Difference d = compare(wanted, pixels);
        if (!(d.variance > LEAST_VARIANCE * WINDOW * WINDOW))
            return LevelEnd::LOST;
        correlation = d.product / std::sqrt(d.variance * wanted.squares);
        if (k == MAX_STEPS)
            break;
        // Slopes are free of 1 and of the template, so that gain and bias have dropped out; what remains is in the window's gain.
        const double gain = std::sqrt(d.variance / wanted.squares);
        const Point2d move(-(wanted.inverse(0, 0) * d.slope_x + wanted.inverse(0, 1) * d.slope_y) / gain,
                           -(wanted.inverse(1, 0) * d.slope_x + wanted.inverse(1, 1) * d.slope_y) / gain);
        place += move;
        const Point2d drift = place - at;
        if (!(drift.dot(drift) < MAX_DRIFT * MAX_DRIFT))
            return LevelEnd::LOST;
        if (move.dot(move) < FINE_ENOUGH * FINE_ENOUGH)
            break;
    }
    at = place;
    return LevelEnd::FOUND;
}

} // namespace

bool follow(const GrayPyramid& a, Point2d from, const GrayPyramid& b, const ExpectedPlace& expected, int levels,
            FoundPlace& found)
{
    const Matx22d& map = expected.map;
    const double area = map(0, 0) * map(1, 1) - map(0, 1) * map(1, 0);
    if (!(area > 0))
        return false;
    const Matx22d a_from_b = (1 / area) * Matx22d(map(1, 1), -map(0, 1), -map(1, 0), map(0, 0));
    const int coarser = cvRound(-0.5 * std::log2(area)); // a is read where its pixels are as large as those of b
    Point2d at = expected.at;
    LevelEnd end = LevelEnd::LOST;
    double correlation = 0;
    for (int level = std::min(levels, b.levels()) - 1; level >= 0; --level)
    {
        const int level_a = std::min(std::max(level + coarser, 0), a.levels() - 1);
        const double scale = 1.0 / (1 << level);
        const double scale_a = 1.0 / (1 << level_a);
        Point2d place = scale * at;
        end = followOnLevel(a, level_a, scale_a * from, (scale_a / scale) * a_from_b, b, level, place, correlation);
        if (end == LevelEnd::FOUND)
            at = (1 / scale) * place;
    }
    found.at = at;
    found.correlation = correlation;
    return end == LevelEnd::FOUND;
}

} // namespace gcpw
} // namespace cv
