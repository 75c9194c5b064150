// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#include "perf_precomp.hpp"

#include <map>
#include <opencv2/imgproc.hpp>
#include "geometry/homography.hpp"
#include "registration/features_header.hpp"
#include "registration/keypoints.hpp"
#include "pair_problem.hpp"
#include "thread_count.hpp"

namespace opencv_test { namespace {

const double RADIUS = 77; // px, a fourteenth of the diagonal: the widest search for parallax

const gcpw::Keypoints& keypointsOf(const Mat& image)
{
    static std::map<const uchar*, gcpw::Keypoints> found;
    gcpw::Keypoints& keypoints = found[image.data];
    if (keypoints.points.empty())
    {
        Mat gray;
        cvtColor(image, gray, COLOR_BGR2GRAY);
        keypoints = gcpw::detectKeypoints(gray, Mat(), Size2d(1, 1), gcpw::Params().contrastThreshold);
    }
    return keypoints;
}

PERF_TEST(Gcpw_Matching, near_where_it_is_expected)
{
    const ThreadCount threads(1);
    const gcpw::Keypoints& source = keypointsOf(pairScene().source());
    const gcpw::Keypoints& target = keypointsOf(pairScene().target());
    const Matx33d rough = pairOptions().rough;
    std::vector<gcpw::KeypointMatch> matches;
    TEST_CYCLE()
    {
        matches = gcpw::matchNearby(source, target, [&](Point2d p) { return gcpw::applyHomography(rough, p); }, RADIUS,
                                    gcpw::Params().matchRatio);
    }
    CV_Assert(matches.size() > 500);
    SANITY_CHECK_NOTHING();
}

PERF_TEST(Gcpw_Matching, everywhere_by_brute_force)
{
    const ThreadCount threads(1);
    const gcpw::Keypoints& source = keypointsOf(pairScene().source());
    const gcpw::Keypoints& target = keypointsOf(pairScene().target());
    const BFMatcher matcher(NORM_L2);
    std::vector<std::vector<DMatch>> matches;
    TEST_CYCLE() matcher.knnMatch(source.descriptors, target.descriptors, matches, 2);
    CV_Assert(matches.size() == source.points.size());
    SANITY_CHECK_NOTHING();
}

}} // namespace
