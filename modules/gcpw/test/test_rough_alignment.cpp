// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#include "test_precomp.hpp"

#include "geometry/homography.hpp"
#include "registration/rough_alignment.hpp"
#include "seeded.hpp"

namespace opencv_test { namespace {

using namespace cv::gcpw;

const Size SIZE(640, 480);
const Matx33d TRUTH(1.05, -0.04, 150, 0.03, 0.98, -20, 5e-5, 2e-5, 1);

/// Keypoints of two images under one homography, a share of them with descriptors that lead astray.
void makeKeypoints(int count, double wrong_share, Keypoints& a, Keypoints& b)
{
    RNG rng = seeded(1);
    a.descriptors.create(count, 128, CV_8UC1);
    rng.fill(a.descriptors, RNG::UNIFORM, 0, 256);
    b.descriptors = a.descriptors.clone();
    for (int i = 0; i < count; ++i)
    {
        a.points.emplace_back(rng.uniform(0.0, 640.0), rng.uniform(0.0, 480.0));
        b.points.push_back(i < wrong_share * count ? Point2d(rng.uniform(0.0, 640.0), rng.uniform(0.0, 480.0))
                                                   : applyHomography(TRUTH, a.points[i]));
    }
}

double distance(const Matx33d& found)
{
    double worst = 0;
    for (const Point2d& p : {Point2d(0, 0), Point2d(640, 0), Point2d(0, 480), Point2d(640, 480)})
        worst = std::max(worst, cv::norm(applyHomography(found, p) - applyHomography(TRUTH, p)));
    return worst;
}

TEST(Gcpw_RoughAlignment, a_homography_is_found_among_wrong_matches)
{
    for (const double wrong_share : {0.0, 0.3, 0.6})
    {
        Keypoints a;
        Keypoints b;
        makeKeypoints(200, wrong_share, a, b);
        const RoughAlignment rough = alignRoughly(a, b, {}, {}, SIZE);
        ASSERT_TRUE(rough.found);
        EXPECT_EQ(rough.tentative, 200);
        EXPECT_NEAR(rough.inliers, 200 * (1 - wrong_share), 4);
        EXPECT_LT(distance(rough.b_from_a), wrong_share > 0 ? 1.0 : 1e-6);
    }
}

TEST(Gcpw_RoughAlignment, too_few_matches_are_no_alignment)
{
    Keypoints a;
    Keypoints b;
    makeKeypoints(MIN_MATCHES - 1, 0, a, b);
    const RoughAlignment rough = alignRoughly(a, b, {}, {}, SIZE);
    EXPECT_FALSE(rough.found);
    EXPECT_EQ(rough.tentative, MIN_MATCHES - 1);
    EXPECT_FALSE(alignRoughly(Keypoints(), Keypoints(), {}, {}, SIZE).found);
}

TEST(Gcpw_RoughAlignment, matches_without_a_common_homography_are_no_alignment)
{
    Keypoints a;
    Keypoints b;
    makeKeypoints(60, 1, a, b);
    const RoughAlignment rough = alignRoughly(a, b, {}, {}, SIZE);
    EXPECT_FALSE(rough.found);
    EXPECT_LT(rough.inliers, MIN_MATCHES);
}

TEST(Gcpw_RoughAlignment, a_mirrored_target_is_no_alignment)
{
    Keypoints a;
    Keypoints b;
    makeKeypoints(100, 0, a, b);
    for (Point2d& p : b.points)
        p.x = 640 - p.x;
    const RoughAlignment rough = alignRoughly(a, b, {}, {}, SIZE);
    EXPECT_FALSE(rough.found);
    EXPECT_EQ(rough.inliers, 0) << "none agrees with a plausible homography";
}

TEST(Gcpw_RoughAlignment, a_target_that_collapses_towards_a_line_is_no_alignment)
{
    Keypoints a;
    Keypoints b;
    makeKeypoints(100, 0, a, b);
    for (size_t i = 0; i < a.points.size(); ++i)
        b.points[i] = Point2d(320 + 0.05 * a.points[i].x, a.points[i].y); // its area is still above that of an eightfold zoom
    const RoughAlignment rough = alignRoughly(a, b, {}, {}, SIZE);
    EXPECT_FALSE(rough.found);
    EXPECT_EQ(rough.inliers, 0);
}

TEST(Gcpw_RoughAlignment, matches_on_one_line_are_no_alignment)
{
    for (const double noise_px : {0.0, 0.3})
    {
        Keypoints a;
        Keypoints b;
        makeKeypoints(100, 0, a, b);
        RNG rng = seeded(4);
        for (size_t i = 0; i < a.points.size(); ++i)
        {
            const double t = rng.uniform(0.0, 1.0);
            a.points[i] = Point2d(20 + 600 * t, 100 + 250 * t);
            b.points[i] = applyHomography(TRUTH, a.points[i]) + Point2d(rng.gaussian(noise_px), rng.gaussian(noise_px));
        }
        const RoughAlignment rough = alignRoughly(a, b, {}, {}, SIZE);
        EXPECT_FALSE(rough.found) << noise_px << rough.b_from_a << distance(rough.b_from_a);
        EXPECT_EQ(rough.inliers, 0) << noise_px;
    }
}

TEST(Gcpw_RoughAlignment, lines_help_where_points_are_few_and_noisy)
{
    Keypoints a;
    Keypoints b;
    makeKeypoints(40, 0, a, b);
    RNG rng = seeded(2);
    for (Point2d& p : b.points)
        p += Point2d(rng.gaussian(1), rng.gaussian(1));
    std::vector<Segment> lines_a;
    std::vector<Segment> lines_b;
    for (int i = 0; i < 60; ++i)
    {
        const Point2d start(rng.uniform(0.0, 640.0), rng.uniform(0.0, 480.0));
        const double angle = rng.uniform(0.0, 2 * CV_PI);
        lines_a.push_back({start, start + 60 * Point2d(std::cos(angle), std::sin(angle))});
        lines_b.push_back({applyHomography(TRUTH, lines_a.back().start), applyHomography(TRUTH, lines_a.back().end)});
    }
    const double points_alone = distance(alignRoughly(a, b, {}, {}, SIZE).b_from_a);
    const double with_lines = distance(alignRoughly(a, b, lines_a, lines_b, SIZE).b_from_a);
    EXPECT_LT(with_lines, 0.7 * points_alone);
}

}} // namespace
