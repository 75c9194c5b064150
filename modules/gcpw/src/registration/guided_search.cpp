// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#include "registration/guided_search.hpp"

#include <optional>
#include <opencv2/core/utility.hpp>
#include "registration/window_tracker.hpp"

namespace cv
{
namespace gcpw
{

namespace
{

const double SLOPE_STEP = 4;          ///< px between the predictions that tell how a window is mapped
const double MAX_RETURN = 0.7;        ///< px between a corner and where the way back ends
const double LEAST_CORRELATION = 0.7; ///< of both windows at the end

std::optional<ExpectedPlace> expectedPlace(Point2d p, const Prediction& b_from_a)
{
    const auto at = b_from_a(p);
    if (!at)
        return std::nullopt;
    ExpectedPlace place;
    place.at = *at;
    const Point2d axes[] = {Point2d(SLOPE_STEP, 0), Point2d(0, SLOPE_STEP)};
    for (int k = 0; k < 2; ++k)
    {
        double sign = 1;
        auto beside = b_from_a(p + axes[k]);
        if (!beside)
        {
            sign = -1;
            beside = b_from_a(p - axes[k]);
        }
        if (!beside)
            return std::nullopt;
        const Point2d slope = (*beside - *at) * (sign / SLOPE_STEP);
        place.map(0, k) = slope.x;
        place.map(1, k) = slope.y;
    }
    // A shift, but for rounding: windows are then read without resampling.
    if (norm(place.map - Matx22d::eye(), NORM_INF) < 1e-6)
        place.map = Matx22d::eye();
    return place;
}

bool search(const GrayPyramid& a, Point2d corner, const GrayPyramid& b, const Prediction& b_from_a, int levels,
            PointMatch& match)
{
    const auto there = expectedPlace(corner, b_from_a);
    FoundPlace found;
    if (!there || !follow(a, corner, b, *there, levels, found) || found.correlation < LEAST_CORRELATION ||
        !b.shows(found.at))
        return false;
    ExpectedPlace back;
    back.map = there->map.inv();
    back.at = corner + Point2d(back.map * Vec2d(found.at.x - there->at.x, found.at.y - there->at.y));
    FoundPlace returned;
    if (!follow(b, found.at, a, back, levels, returned) || !(norm(returned.at - corner) < MAX_RETURN))
        return false;
    match.a = corner;
    match.b = found.at;
    return true;
}

} // namespace

std::vector<PointMatch> searchCorners(const GrayPyramid& a, const std::vector<Point>& corners, const GrayPyramid& b,
                                      const Prediction& b_from_a, int levels)
{
    std::vector<PointMatch> found(corners.size());
    std::vector<uchar> kept(corners.size(), 0);
    parallel_for_(Range(0, static_cast<int>(corners.size())),
                  [&](const Range& range)
                  {
        for (int i = range.start; i < range.end; ++i)
            kept[i] = search(a, corners[i], b, b_from_a, levels, found[i]) ? 1 : 0;
    });
    std::vector<PointMatch> matches;
    for (size_t i = 0; i < corners.size(); ++i)
        if (kept[i])
            matches.push_back(found[i]);
    return matches;
}

} // namespace gcpw
} // namespace cv
