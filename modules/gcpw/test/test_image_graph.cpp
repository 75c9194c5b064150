// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#include "test_precomp.hpp"

#include <algorithm>
#include <limits>
#include "registration/image_graph.hpp"

namespace opencv_test { namespace {

using namespace cv::gcpw;

const Size SIZE(100, 80);

std::vector<Mat> fullMasks(size_t count)
{
    return std::vector<Mat>(count, Mat(SIZE, CV_8U, Scalar(255)));
}

bool has(const std::vector<Overlap>& overlaps, int a, int b)
{
    return std::any_of(overlaps.begin(), overlaps.end(), [=](const Overlap& o) { return o.a == a && o.b == b; });
}

TEST(Gcpw_ImageGraph, images_that_share_pixels_overlap)
{
    const std::vector<Point> corners = {Point(0, 0), Point(60, 10), Point(150, 0)};
    const std::vector<Overlap> overlaps = findOverlaps(corners, fullMasks(3));
    ASSERT_EQ(overlaps.size(), 2u);
    EXPECT_TRUE(has(overlaps, 0, 1));
    EXPECT_TRUE(has(overlaps, 1, 2));
    EXPECT_EQ(overlaps[0].area, 40 * 70);
}

TEST(Gcpw_ImageGraph, masks_count_and_not_boxes)
{
    std::vector<Mat> masks = fullMasks(2);
    masks[1] = masks[1].clone();
    masks[1].colRange(0, 40) = Scalar(0);
    EXPECT_TRUE(findOverlaps({Point(0, 0), Point(60, 10)}, masks).empty());
}

TEST(Gcpw_ImageGraph, a_wrapping_canvas_joins_its_ends)
{
    const std::vector<Overlap> overlaps = findOverlaps({Point(0, 0), Point(340, 0)}, fullMasks(2), 400);
    ASSERT_EQ(overlaps.size(), 1u);
    EXPECT_EQ(overlaps[0].period_offset_b, -1);
    EXPECT_EQ(overlaps[0].area, 40 * 80);
}

TEST(Gcpw_ImageGraph, few_images_are_all_compared)
{
    const std::vector<Point> corners = {Point(0, 0), Point(20, 0), Point(40, 0), Point(60, 0)};
    const std::vector<Mat> masks = fullMasks(4);
    const std::vector<Overlap> all = findOverlaps(corners, masks);
    EXPECT_EQ(all.size(), 6u);
    EXPECT_EQ(withoutRepetition(all, corners, masks, 0, 3).size(), 6u);
}

TEST(Gcpw_ImageGraph, many_images_of_one_place_are_compared_in_proportion_and_stay_connected)
{
    std::vector<Point> corners;
    for (int i = 0; i < 40; ++i)
        corners.emplace_back(2 * i, i % 3);
    const std::vector<Mat> masks = fullMasks(corners.size());
    const std::vector<Overlap> all = findOverlaps(corners, masks);
    const std::vector<Overlap> some = withoutRepetition(all, corners, masks, 0, 3);
    EXPECT_GT(all.size(), 600u);
    EXPECT_LE(some.size(), 4 * corners.size());
    std::vector<int> reached(1, 0);
    for (size_t k = 0; k < reached.size(); ++k)
        for (const Overlap& o : some)
            for (const int next : {o.a, o.b})
                if ((o.a == reached[k] || o.b == reached[k]) && std::find(reached.begin(), reached.end(), next) == reached.end())
                    reached.push_back(next);
    EXPECT_EQ(reached.size(), corners.size());
}

TEST(Gcpw_ImageGraph, an_overlap_in_a_corner_of_its_own_is_kept)
{
    // Four near-copies share everything; the fifth meets them with its edge alone.
    const std::vector<Point> corners = {Point(0, 0), Point(1, 0), Point(0, 1), Point(1, 1), Point(90, 0)};
    const std::vector<Mat> masks = fullMasks(5);
    const std::vector<Overlap> some = withoutRepetition(findOverlaps(corners, masks), corners, masks, 0, 1);
    EXPECT_TRUE(std::any_of(some.begin(), some.end(), [](const Overlap& o) { return o.b == 4; }));
}

TEST(Gcpw_ImageGraph, the_central_image_reaches_all_others_soonest)
{
    const std::vector<Point> corners = {Point(0, 0), Point(240, 0), Point(160, 0), Point(80, 0), Point(320, 0)};
    EXPECT_EQ(mostCentral(5, findOverlaps(corners, fullMasks(5))), 2);
}

TEST(Gcpw_ImageGraph, corners_may_lie_at_the_ends_of_the_numbers)
{
    const int far = std::numeric_limits<int>::max();
    const std::vector<Mat> masks = fullMasks(2);
    EXPECT_TRUE(findOverlaps({Point(far, far), Point(-far - 1, 0)}, masks).empty());
    EXPECT_TRUE(findOverlaps({Point(-far - 1, 0), Point(far, 0)}, masks).empty());
    const std::vector<Point> corners = {Point(far, far), Point(far - 60, far - 10)};
    const std::vector<Overlap> near = findOverlaps(corners, masks);
    ASSERT_EQ(near.size(), 1u);
    EXPECT_EQ(near[0].area, 40 * 70);
    EXPECT_EQ(withoutRepetition(near, corners, masks, 0, 1).size(), 1u);
    // 4294967295 = 42949672 * 100 + 95
    const std::vector<Point> ends = {Point(far, 0), Point(-far - 1, 0)};
    const std::vector<Overlap> wrapped = findOverlaps(ends, masks, 100);
    ASSERT_EQ(wrapped.size(), 2u) << "on both sides";
    EXPECT_EQ(wrapped[0].period_offset_b, 42949672);
    EXPECT_EQ(wrapped[0].area, 5 * 80);
    EXPECT_EQ(wrapped[1].area, 95 * 80);
    EXPECT_EQ(withoutRepetition(wrapped, ends, masks, 100, 1).size(), 2u);
}

}} // namespace
