// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#include "registration/pair_matcher.hpp"

#include <algorithm>
#include <cmath>
#include <opencv2/core/utils/logger.hpp>
#include <opencv2/imgproc.hpp>
#include "registration/match_filter.hpp"

namespace cv
{
namespace gcpw
{

namespace
{

const double SEARCH_SHARE = 0.07;   ///< of the image diagonal: how far parallax may carry a keypoint from the homography
const double REFINED_RADIUS = 10;   ///< px: how far from a fitted mesh a keypoint is looked for
const double MIN_SEGMENT_LENGTH = 20; ///< px

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

} // namespace

MatchKinds matchesUsedBy(Method method)
{
    MatchKinds kinds;
    kinds.points = method >= Method::CPW;
    kinds.lines = method >= Method::DFW;
    return kinds;
}

Features detectFeatures(const Mat& image, const Mat& mask, Size2d to_reference, const Params& params)
{
    Mat gray;
    cvtColor(image, gray, COLOR_BGR2GRAY);
    Features features;
    features.keypoints = detectKeypoints(gray, mask, to_reference, params.contrastThreshold);
    features.segments = detectSegments(gray, mask, to_reference, MIN_SEGMENT_LENGTH);
    return features;
}

Features knownFeatures(const Mat& image, const Mat& mask, Size2d to_reference, const Keypoints& keypoints)
{
    Mat gray;
    cvtColor(image, gray, COLOR_BGR2GRAY);
    Features features;
    features.keypoints = keypoints;
    features.segments = detectSegments(gray, mask, to_reference, MIN_SEGMENT_LENGTH);
    return features;
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
    const auto matchAround = [&](double search_radius)
    {
        std::vector<PointMatch> points = toPointMatches(
            a.keypoints, b.keypoints,
            matchNearby(a.keypoints, b.keypoints, expectation(fitted, fixed, shift_b), search_radius, params.matchRatio));
        const MatchFilterStatus status = filterMatches(points, fitted, rough, fixed, shift_b, schedule);
        if (status != MatchFilterStatus::Unsolved)
            matches.points.swap(points);
        return status;
    };
    const MatchFilterStatus first = matchAround(SEARCH_SHARE * std::hypot(size.width, size.height));
    if (first == MatchFilterStatus::Unsolved)
    {
        CV_LOG_WARNING(nullptr, "gcpw: no mesh fits the matches of a pair; it is aligned without any");
        return matches;
    }
    // Around the rough mesh, which is what remains of a folded fit, the small radius would lose all parallax.
    if (params.guidedMatching != 0 && first == MatchFilterStatus::Fitted)
    {
        schedule.start_px = REFINED_RADIUS;
        if (matchAround(REFINED_RADIUS) == MatchFilterStatus::Unsolved)
            CV_LOG_WARNING(nullptr, "gcpw: no mesh fits the guided matches of a pair; those found before are kept");
    }
    if (kinds.lines)
        matches.lines = matchSegments(a.segments, b.segments, expectation(fitted, fixed, shift_b), SegmentTolerance());
    return matches;
}

} // namespace gcpw
} // namespace cv
