// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#include "registration/pair_matcher.hpp"

#include <algorithm>
#include <cmath>
#include <opencv2/core/utils/logger.hpp>
#include "registration/guided_search.hpp"
#include "registration/match_filter.hpp"

namespace cv
{
namespace gcpw
{

namespace
{

const double SEARCH_SHARE = 0.07;   ///< of the image diagonal: how far parallax may carry a keypoint from the homography
const double REFINED_RADIUS = 10;   ///< px: how far from a fitted mesh a keypoint is looked for
const int ROUGH_LEVELS = 4;         ///< of the tracking along the rough mesh: bridges about 50 px
const int REFINED_LEVELS = 2;       ///< along a fitted one
const size_t LEADING = 20;          ///< keypoint matches from which on a mesh fitted to them may lead the tracking

Prediction expectation(const MeshGrid& moving, const MeshGrid& fixed, Point2d shift)
{
    return [&moving, &fixed, shift](Point2d p) -> std::optional<Point2d>
    {
        int hint = -1;
        CellPoint point;
        if (!fixed.invert(moving.warp(p) - shift, hint, point))
            return std::nullopt;
        return fixed.lattice().referencePoint(point);
    };
}

void append(const std::vector<PointMatch>& more, std::vector<PointMatch>& points)
{
    points.insert(points.end(), more.begin(), more.end());
}

} // namespace

MatchKinds matchesUsedBy(Method method)
{
    MatchKinds kinds;
    kinds.points = method >= Method::CPW;
    kinds.lines = method >= Method::DFW;
    return kinds;
}

MatchSet matchPair(const Features& a, const Features& b, const MeshGrid& rough, const MeshGrid& fixed, Point2d shift_b,
                   const Params& params, MatchKinds kinds)
{
    MatchSet matches;
    if (!kinds.points)
        return matches;
    const Size size = fixed.lattice().imageSize();
    MeshGrid fitted = rough;
    MatchFilterSchedule schedule;
    schedule.similarity_weight = std::max(params.similarityWeight, schedule.similarity_weight);
    const bool tracking = a.pyramid.levels() > 0 && b.pyramid.levels() > 0;
    const auto near = [&](double search_radius)
    {
        return toPointMatches(a.keypoints, b.keypoints,
                              matchNearby(a.keypoints, b.keypoints, expectation(fitted, fixed, shift_b), search_radius,
                                          params.matchRatio));
    };
    const auto follow = [&](int levels)
    { return searchCorners(a.pyramid, a.corners, b.pyramid, expectation(fitted, fixed, shift_b), levels); };
    const auto keep = [&](std::vector<PointMatch> points)
    {
        const MatchFilterStatus status = filterMatches(points, fitted, rough, fixed, shift_b, schedule);
        if (status != MatchFilterStatus::Unsolved)
            matches.points.swap(points);
        return status;
    };
    std::vector<PointMatch> points = near(SEARCH_SHARE * std::hypot(size.width, size.height));
    const bool led = tracking && params.guidedMatching != 0 && points.size() >= LEADING;
    if (tracking && !led)
        append(follow(ROUGH_LEVELS), points);
    const MatchFilterStatus first = keep(points);
    if (first == MatchFilterStatus::Unsolved)
    {
        CV_LOG_WARNING(nullptr, "gcpw: no mesh fits the matches of a pair; it is aligned without any");
        return matches;
    }
    const bool fits = first == MatchFilterStatus::Fitted;
    // Around the rough mesh, which is what remains of a folded fit, a short search would lose all parallax.
    if (params.guidedMatching != 0 && (fits || led))
    {
        schedule.start_px = fits ? REFINED_RADIUS : schedule.start_px;
        if (keep(tracking ? follow(led ? ROUGH_LEVELS : REFINED_LEVELS) : near(REFINED_RADIUS)) ==
            MatchFilterStatus::Unsolved)
            CV_LOG_WARNING(nullptr, "gcpw: no mesh fits the guided matches of a pair; those found before are kept");
    }
    if (kinds.lines)
        matches.lines = matchSegments(a.segments, b.segments, expectation(fitted, fixed, shift_b), SegmentTolerance());
    return matches;
}

} // namespace gcpw
} // namespace cv
