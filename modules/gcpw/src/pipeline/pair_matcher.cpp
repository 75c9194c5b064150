// Part of the GCPW module for OpenCV. Licence: Apache-2.0 (see LICENSE).
#include "pipeline/pair_matcher.hpp"

#include <cmath>
#include <opencv2/imgproc.hpp>
#include "pipeline/match_gate.hpp"

namespace cv
{
namespace gcpw
{

namespace
{

const double SEARCH_SHARE = 0.07;   ///< of the image diagonal: how far parallax may carry a keypoint from the homography
const double REFINED_RADIUS = 10;   ///< px: how far from a fitted mesh a keypoint is looked for
const double MIN_SEGMENT_LENGTH = 20; ///< px

std::function<Point2d(Point2d)> expectation(const MeshGrid& moving, const MeshGrid& fixed, Point2d shift)
{
    return [&moving, &fixed, shift](Point2d p)
    {
        int hint = -1;
        CellPoint point;
        if (!fixed.invert(moving.warp(p) - shift, hint, point))
            return Point2d(-1e6, -1e6); // outside the fixed image: near no keypoint
        return fixed.lattice().restPoint(point);
    };
}

} // namespace

Features detectFeatures(const Mat& image, const Mat& mask, Size work_size, const Params& params)
{
    Mat gray;
    cvtColor(image, gray, COLOR_BGR2GRAY);
    const Size2d to_rest(static_cast<double>(work_size.width) / gray.cols,
                         static_cast<double>(work_size.height) / gray.rows);
    Features features;
    features.keypoints = detectKeypoints(gray, mask, to_rest, params.contrastThreshold);
    features.segments = detectSegments(gray, to_rest, MIN_SEGMENT_LENGTH);
    return features;
}

Features knownFeatures(const Mat& image, const Keypoints& keypoints)
{
    Mat gray;
    cvtColor(image, gray, COLOR_BGR2GRAY);
    Features features;
    features.keypoints = keypoints;
    features.segments = detectSegments(gray, Size2d(1, 1), MIN_SEGMENT_LENGTH);
    return features;
}

MatchSet matchPair(const Features& a, const Features& b, const MeshGrid& rough, const MeshGrid& fixed, Point2d shift_b,
                   const Params& params, const Recipe& recipe)
{
    MatchSet matches;
    if (!recipe.points)
        return matches;
    const Size size = fixed.lattice().imageSize();
    const double radius = SEARCH_SHARE * std::hypot(size.width, size.height);
    MeshGrid fitted = rough;
    GateSchedule schedule;
    schedule.similarity_weight = params.similarityWeight;
    const auto matchAround = [&](double search_radius)
    {
        matches.points = toPointMatches(a.keypoints, b.keypoints,
                                        matchNearby(a.keypoints, b.keypoints, expectation(fitted, fixed, shift_b), search_radius,
                                                    params.matchRatio));
        gateMatches(matches.points, fitted, rough, fixed, shift_b, schedule);
    };
    matchAround(radius);
    schedule.start_px = REFINED_RADIUS;
    matchAround(REFINED_RADIUS);
    if (recipe.lines)
        matches.lines = matchSegments(a.segments, b.segments, expectation(fitted, fixed, shift_b), SegmentTolerance());
    return matches;
}

} // namespace gcpw
} // namespace cv
