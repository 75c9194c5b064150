// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#include "registration/rough_alignment.hpp"

#include "geometry/homography.hpp"

// OpenCV 5 split calib3d; findHomography() is in the part called geometry.
#if CV_VERSION_MAJOR >= 5
#include <opencv2/geometry.hpp>
#else
#include <opencv2/calib3d.hpp>
#endif

namespace cv
{
namespace gcpw
{

namespace
{

const int STRONGEST = 3000;          ///< keypoints an image that are matched without a guess of where to look
const double BLIND_RATIO = 0.8;      ///< ratio test of the blind matching (Lowe's value)
const double RANSAC_THRESHOLD = 4.0; ///< px
const double MAX_ZOOM = 8;           ///< local scale change beyond which a homography is taken to be wrong
const int REFITS = 3;                ///< each re-selects the inliers; more changed nothing
const double LINE_WEIGHT = 0.5;      ///< of a line end against a point: an end gives one equation, a point two

} // namespace

RoughAlignment alignRoughly(const Keypoints& keypoints_a, const Keypoints& keypoints_b,
                            const std::vector<Segment>& segments_a, const std::vector<Segment>& segments_b, Size size_a)
{
    RoughAlignment rough;
    const std::vector<PointMatch> matches =
        toPointMatches(keypoints_a, keypoints_b, matchEverywhere(keypoints_a, keypoints_b, STRONGEST, BLIND_RATIO));
    rough.tentative = static_cast<int>(matches.size());
    if (rough.tentative < MIN_MATCHES)
        return rough;
    std::vector<Point2d> from;
    std::vector<Point2d> to;
    for (const PointMatch& match : matches)
    {
        from.push_back(match.a);
        to.push_back(match.b);
    }
    // OpenCV seeds this RANSAC itself, always alike: theRNG() is neither read nor moved on.
    const Mat found = findHomography(from, to, RANSAC, RANSAC_THRESHOLD, noArray(), 5000, 0.999);
    if (found.empty())
        return rough;
    Matx33d h(found.ptr<double>());
    for (int refit = 0; refit < REFITS; ++refit)
    {
        std::vector<PointMatch> inliers;
        for (const PointMatch& match : matches)
            if (norm(applyHomography(h, match.a) - match.b) < RANSAC_THRESHOLD)
                inliers.push_back(match);
        // Nothing agrees with a plausible homography if it mirrors, collapses or tears the image.
        rough.inliers = isPlausible(h, size_a, MAX_ZOOM) ? static_cast<int>(inliers.size()) : 0;
        if (rough.inliers < MIN_MATCHES)
            return rough;
        std::vector<LineMatch> lines = matchSegments(
            segments_a, segments_b, [&](Point2d p) { return applyHomography(h, p); }, SegmentTolerance());
        for (LineMatch& line : lines)
            line.weight *= LINE_WEIGHT;
        Matx33d refined;
        if (!fitHomography(inliers, lines, refined))
        {
            rough.inliers = 0; // matches on one line, say: they agree with many homographies, and RANSAC's is one of them
            return rough;
        }
        if (!isPlausible(refined, size_a, MAX_ZOOM))
            break;
        h = refined;
    }
    rough.b_from_a = h;
    rough.found = true;
    return rough;
}

} // namespace gcpw
} // namespace cv
