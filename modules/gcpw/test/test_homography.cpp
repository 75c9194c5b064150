// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#include "test_precomp.hpp"

#include "geometry/homography.hpp"
#include "seeded.hpp"

namespace opencv_test { namespace {

using namespace cv::gcpw;

const Matx33d TRUTH(1.1, -0.08, 120, 0.05, 0.96, -40, 1e-4, -5e-5, 1);

std::vector<PointMatch> truePoints(int count, uint64_t seed)
{
    RNG rng = seeded(seed);
    std::vector<PointMatch> matches(count);
    for (PointMatch& match : matches)
    {
        match.a = Point2d(rng.uniform(0.0, 640.0), rng.uniform(0.0, 480.0));
        match.b = applyHomography(TRUTH, match.a);
    }
    return matches;
}

/// Targets on the same line that end elsewhere, as detectors leave them.
std::vector<LineMatch> trueLines(int count, uint64_t seed)
{
    RNG rng = seeded(seed);
    std::vector<LineMatch> matches(count);
    for (LineMatch& match : matches)
    {
        match.a.start = Point2d(rng.uniform(0.0, 640.0), rng.uniform(0.0, 480.0));
        match.a.end = Point2d(rng.uniform(0.0, 640.0), rng.uniform(0.0, 480.0));
        match.b.start = applyHomography(TRUTH, match.a.at(-0.2));
        match.b.end = applyHomography(TRUTH, match.a.at(0.7));
    }
    return matches;
}

double distance(const Matx33d& found)
{
    double worst = 0;
    for (const Point2d& p : {Point2d(0, 0), Point2d(640, 0), Point2d(0, 480), Point2d(640, 480), Point2d(320, 240)})
        worst = std::max(worst, cv::norm(applyHomography(found, p) - applyHomography(TRUTH, p)));
    return worst;
}

TEST(Gcpw_Homography, points_alone_fix_it_exactly)
{
    for (const int count : {4, 5, 50})
    {
        Matx33d found;
        ASSERT_TRUE(fitHomography(truePoints(count, 1), {}, found));
        EXPECT_LT(distance(found), 1e-6) << count;
    }
}

TEST(Gcpw_Homography, lines_alone_fix_it_exactly)
{
    for (const int count : {4, 5, 30})
    {
        Matx33d found;
        ASSERT_TRUE(fitHomography({}, trueLines(count, 2), found));
        EXPECT_LT(distance(found), 1e-6) << count;
    }
}

TEST(Gcpw_Homography, points_and_lines_fix_it_together)
{
    Matx33d found;
    for (const int points : {1, 3, 20})
    {
        ASSERT_TRUE(fitHomography(truePoints(points, 3), trueLines(points == 1 ? 3 : 1, 13), found)) << points;
        EXPECT_LT(distance(found), 1e-5) << points;
    }
}

TEST(Gcpw_Homography, a_match_counts_by_its_weight)
{
    std::vector<PointMatch> points = truePoints(20, 4);
    points[7].b += Point2d(30, -20);
    Matx33d found;
    ASSERT_TRUE(fitHomography(points, {}, found));
    EXPECT_GT(distance(found), 1);
    points[7].weight = 1e-9;
    ASSERT_TRUE(fitHomography(points, {}, found));
    EXPECT_LT(distance(found), 1e-3);
    std::vector<LineMatch> lines = trueLines(12, 4);
    lines[3].b.start += Point2d(40, 40);
    lines[3].weight = 1e-9;
    ASSERT_TRUE(fitHomography({}, lines, found));
    EXPECT_LT(distance(found), 1e-3);
}

TEST(Gcpw_Homography, noise_averages_out)
{
    std::vector<PointMatch> points = truePoints(400, 5);
    RNG rng = seeded(6);
    for (PointMatch& match : points)
        match.b += Point2d(rng.gaussian(1), rng.gaussian(1));
    Matx33d found;
    ASSERT_TRUE(fitHomography(points, {}, found));
    EXPECT_LT(distance(found), 1.0);
}

TEST(Gcpw_Homography, data_that_leave_it_open_are_refused)
{
    Matx33d found;
    EXPECT_FALSE(fitHomography({}, {}, found));
    EXPECT_FALSE(fitHomography(truePoints(3, 7), {}, found));
    EXPECT_FALSE(fitHomography({}, trueLines(3, 7), found));
    std::vector<PointMatch> in_line = truePoints(10, 8);
    for (PointMatch& match : in_line)
    {
        match.a.y = 2 * match.a.x + 5;
        match.b = applyHomography(TRUTH, match.a);
    }
    EXPECT_FALSE(fitHomography(in_line, {}, found));
    // Where the two lines meet is in line with nothing but the lines: a family of homographies is left.
    EXPECT_FALSE(fitHomography(truePoints(2, 3), trueLines(2, 13), found));
    const std::vector<PointMatch> one_spot(6, truePoints(1, 9)[0]);
    EXPECT_FALSE(fitHomography(one_spot, {}, found));
    std::vector<LineMatch> parallel = trueLines(6, 10);
    for (size_t i = 0; i < parallel.size(); ++i)
    {
        parallel[i].a = {Point2d(0, 50.0 * i), Point2d(600, 50.0 * i)};
        parallel[i].b = {applyHomography(TRUTH, parallel[i].a.start), applyHomography(TRUTH, parallel[i].a.end)};
    }
    EXPECT_FALSE(fitHomography({}, parallel, found));
    std::vector<PointMatch> broken = truePoints(10, 11);
    broken[4].b.x = std::numeric_limits<double>::quiet_NaN();
    EXPECT_FALSE(fitHomography(broken, {}, found));
}

TEST(Gcpw_Homography, a_line_without_length_says_nothing)
{
    std::vector<LineMatch> lines = trueLines(8, 12);
    lines[2].b.end = lines[2].b.start;
    Matx33d found;
    ASSERT_TRUE(fitHomography({}, lines, found));
    EXPECT_LT(distance(found), 1e-6);
}

TEST(Gcpw_Homography, plausible_is_upright_finite_and_not_much_zoomed_anywhere)
{
    const Size size(640, 480);
    EXPECT_TRUE(isPlausible(Matx33d::eye(), size, 8));
    EXPECT_TRUE(isPlausible(TRUTH, size, 8));
    EXPECT_FALSE(isPlausible(Matx33d(-1, 0, 640, 0, 1, 0, 0, 0, 1), size, 8)) << "mirrored";
    EXPECT_TRUE(isPlausible(Matx33d(-1, 0, 640, 0, -1, 480, 0, 0, 1), size, 8)) << "turned";
    EXPECT_FALSE(isPlausible(Matx33d(9, 0, 0, 0, 9, 0, 0, 0, 1), size, 8));
    EXPECT_FALSE(isPlausible(Matx33d(0.1, 0, 0, 0, 0.1, 0, 0, 0, 1), size, 8));
    EXPECT_FALSE(isPlausible(Matx33d(1, 0, 0, 0, 1, 0, -2e-3, 0, 1), size, 8)) << "a horizon inside";
    EXPECT_FALSE(isPlausible(Matx33d(0.1, 0, 0, 0, 1, 0, 0, 0, 1), size, 8)) << "collapsed in one direction";
    EXPECT_TRUE(isPlausible(Matx33d(0.2, 0, 0, 0, 0.2, 0, 0, 0, 1), size, 8));
    EXPECT_FALSE(isPlausible(Matx33d::zeros(), size, 8));
    EXPECT_FALSE(isPlausible(Matx33d::all(std::numeric_limits<double>::quiet_NaN()), size, 8));
}

TEST(Gcpw_Segment, a_line_is_zero_on_the_segment_and_a_signed_distance_beside_it)
{
    const Segment segment{Point2d(10, 20), Point2d(40, 60)}; // 30, 40, 50
    EXPECT_NEAR(segment.length(), 50, 1e-12);
    const Line line = segment.line();
    for (const double t : {-1.0, 0.0, 0.3, 1.0, 2.0})
        EXPECT_NEAR(line.distance(segment.at(t)), 0, 1e-10);
    const Point2d aside(-0.8, 0.6);
    EXPECT_NEAR(line.distance(segment.at(0.4) + 7 * aside), 7, 1e-10);
    EXPECT_NEAR(line.distance(segment.at(0.4) - 7 * aside), -7, 1e-10);
    EXPECT_NEAR(cv::norm(line.normal), 1, 1e-12);
}

}} // namespace
