// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#include "test_precomp.hpp"

#include <opencv2/imgproc.hpp>
#include "geometry/curve.hpp"
#include "registration/straight_lines.hpp"

namespace opencv_test { namespace {

using namespace cv::gcpw;

Segment segment(double x0, double y0, double x1, double y1)
{
    return {Point2d(x0, y0), Point2d(x1, y1)};
}

TEST(Gcpw_StraightLines, pieces_of_one_line_are_joined)
{
    const std::vector<Segment> found = joinSegments({segment(10, 10, 60, 10.4), segment(110, 10.2, 70, 10.1), segment(120, 10, 180, 10)}, 30);
    ASSERT_EQ(found.size(), 1u);
    EXPECT_NEAR(found[0].length(), 170, 1);
}

TEST(Gcpw_StraightLines, what_is_not_on_one_line_stays_apart)
{
    EXPECT_EQ(joinSegments({segment(10, 10, 60, 10), segment(70, 16, 120, 16)}, 30).size(), 2u);  // beside it
    EXPECT_EQ(joinSegments({segment(10, 10, 60, 10), segment(62, 10, 110, 20)}, 30).size(), 2u);  // turned
    EXPECT_EQ(joinSegments({segment(10, 10, 50, 10), segment(150, 10, 190, 10)}, 30).size(), 2u); // far away
}

TEST(Gcpw_StraightLines, short_lines_are_left_out_unless_they_join)
{
    EXPECT_TRUE(joinSegments({segment(10, 10, 30, 10)}, 30).empty());
    EXPECT_EQ(joinSegments({segment(10, 10, 30, 10), segment(34, 10, 55, 10)}, 30).size(), 1u);
}

TEST(Gcpw_StraightLines, of_lines_side_by_side_the_longest_stands_for_all)
{
    const std::vector<Segment> found = joinSegments({segment(20, 12, 90, 12), segment(10, 10, 110, 10), segment(10, 40, 110, 40)}, 30);
    ASSERT_EQ(found.size(), 2u);
    EXPECT_EQ(found[0].start.y, 10);
    EXPECT_EQ(found[1].start.y, 40);
}

TEST(Gcpw_StraightLines, segments_without_length_are_no_lines)
{
    EXPECT_TRUE(joinSegments({segment(10, 10, 10, 10), segment(0, 0, std::nan(""), 4)}, 0).empty());
}

TEST(Gcpw_StraightLines, they_are_found_in_an_image_and_heed_its_mask)
{
    Mat image(240, 320, CV_8UC3, Scalar::all(60));
    rectangle(image, Rect(60, 50, 200, 140), Scalar::all(200), FILLED);
    const std::vector<Segment> all = findStraightLines(image, Mat());
    ASSERT_GE(all.size(), 4u);
    EXPECT_GT(all[0].length(), 180);
    Mat mask(image.size(), CV_8UC1, Scalar::all(0));
    mask(Rect(0, 0, 320, 120)).setTo(255);
    const std::vector<Segment> upper = findStraightLines(image, mask);
    ASSERT_FALSE(upper.empty());
    for (const Segment& line : upper)
        EXPECT_LT(std::max(line.start.y, line.end.y), 120);
}

TEST(Gcpw_StraightLines, the_borders_of_an_image_go_through_its_outermost_pixels)
{
    const std::vector<Segment> borders = bordersOf(Size(80, 60));
    ASSERT_EQ(borders.size(), 4u);
    const Point2d corners[] = {Point2d(0, 0), Point2d(79, 0), Point2d(79, 59), Point2d(0, 59)};
    for (int k = 0; k < 4; ++k)
    {
        EXPECT_EQ(borders[k].start, corners[k]) << k;
        EXPECT_EQ(borders[k].end, corners[(k + 1) % 4]) << k;
    }
}

TEST(Gcpw_Curve, samples_are_equally_far_apart_along_the_polygon)
{
    const Curve bent = {Point2d(0, 0), Point2d(30, 0), Point2d(30, 0), Point2d(30, 40)};
    EXPECT_EQ(lengthOf(bent), 70);
    const Curve samples = resampled(bent, 10);
    ASSERT_EQ(samples.size(), 8u);
    EXPECT_EQ(samples[0], Point2d(0, 0));
    EXPECT_EQ(samples[3], Point2d(30, 0));
    EXPECT_EQ(samples[4], Point2d(30, 10));
    EXPECT_EQ(samples[7], Point2d(30, 40));
    EXPECT_TRUE(resampled({Point2d(3, 3), Point2d(3, 3)}, 10).empty());
    EXPECT_TRUE(resampled({}, 10).empty());
}

}} // namespace
