// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#include "test_precomp.hpp"

#include "imaging/photograph.hpp"
#include "registration/segments.hpp"
#include "seeded.hpp"

namespace opencv_test { namespace {

using namespace cv::gcpw;

const Size2d SAME(1, 1);
const Mat EVERYWHERE;

Point2d stay(Point2d p)
{
    return p;
}

/// A bright rectangle on dark ground: edges at x = 39.5, 159.5 and y = 29.5, 89.5.
Mat brightRectangle()
{
    Mat gray(140, 200, CV_8UC1, Scalar(60));
    gray(Rect(40, 30, 120, 60)).setTo(200);
    return gray;
}

Segment segment(double x0, double y0, double x1, double y1)
{
    return {Point2d(x0, y0), Point2d(x1, y1)};
}

bool samePlace(const Segment& a, const Segment& b)
{
    return a.start == b.start && a.end == b.end;
}

TEST(Gcpw_Segments, the_sides_of_a_rectangle_are_found)
{
    const std::vector<Segment> found = detectSegments(brightRectangle(), EVERYWHERE, SAME, 20);
    const Segment sides[] = {segment(39.5, 29.5, 159.5, 29.5), segment(39.5, 89.5, 159.5, 89.5),
                             segment(39.5, 29.5, 39.5, 89.5), segment(159.5, 29.5, 159.5, 89.5)};
    for (const Segment& side : sides)
    {
        int targets = 0;
        for (const Segment& candidate : found)
            targets += std::abs(side.line().distance(candidate.start)) < 1.5 &&
                        std::abs(side.line().distance(candidate.end)) < 1.5 && candidate.length() > 0.7 * side.length();
        EXPECT_GE(targets, 1) << side.start << side.end;
    }
}

TEST(Gcpw_Segments, the_brighter_side_lies_on_one_hand)
{
    const Mat gray = brightRectangle();
    const std::vector<Segment> found = detectSegments(gray, EVERYWHERE, SAME, 20);
    ASSERT_GE(found.size(), 4u);
    for (const Segment& s : found)
    {
        const Point2d d = s.direction() / s.length();
        const Point2d left(d.y, -d.x);
        const Point2d p = s.at(0.5) + 4 * left;
        const Point2d q = s.at(0.5) - 4 * left;
        EXPECT_GT(gray.at<uchar>(cvRound(p.y), cvRound(p.x)), gray.at<uchar>(cvRound(q.y), cvRound(q.x)));
    }
}

TEST(Gcpw_Segments, an_inverted_picture_turns_every_segment_round)
{
    const Mat gray = brightRectangle();
    const std::vector<Segment> found = detectSegments(gray, EVERYWHERE, SAME, 20);
    const std::vector<Segment> inverted = detectSegments(255 - gray, EVERYWHERE, SAME, 20);
    ASSERT_FALSE(found.empty());
    EXPECT_TRUE(matchSegments(found, inverted, stay, SegmentTolerance()).empty());
    EXPECT_EQ(matchSegments(found, found, stay, SegmentTolerance()).size(), found.size());
}

TEST(Gcpw_Segments, they_are_in_reference_pixels_and_longest_first)
{
    const std::vector<Segment> same = detectSegments(brightRectangle(), EVERYWHERE, SAME, 20);
    const std::vector<Segment> scaled = detectSegments(brightRectangle(), EVERYWHERE, Size2d(0.5, 0.5), 10);
    ASSERT_FALSE(same.empty());
    ASSERT_EQ(same.size(), scaled.size());
    for (size_t i = 0; i < same.size(); ++i)
    {
        EXPECT_LT(cv::norm(0.5 * (same[i].start + Point2d(0.5, 0.5)) - Point2d(0.5, 0.5) - scaled[i].start), 1e-6);
        EXPECT_GE(same[i].length(), 20);
        if (i > 0)
        {
            EXPECT_GE(same[i - 1].length(), same[i].length());
        }
    }
}

TEST(Gcpw_Segments, a_flat_or_tiny_picture_has_none)
{
    EXPECT_TRUE(detectSegments(Mat(100, 100, CV_8UC1, Scalar(90)), EVERYWHERE, SAME, 20).empty());
    EXPECT_TRUE(detectSegments(Mat(1, 1, CV_8UC1, Scalar(90)), EVERYWHERE, SAME, 20).empty());
    EXPECT_TRUE(detectSegments(brightRectangle()(Rect(30, 20, 20, 20)), EVERYWHERE, SAME, 20).empty());
}

/// Noise, hidden outside an ellipse: streaks radiate from it.
Photograph maskedNoise()
{
    RNG rng = seeded(5);
    Mat noise(120, 160, CV_8UC1);
    rng.fill(noise, RNG::UNIFORM, 0, 256);
    Photograph photograph;
    resize(noise, noise, Size(480, 360), 0, 0, INTER_CUBIC);
    cvtColor(noise, photograph.image, COLOR_GRAY2BGR);
    Mat mask(photograph.image.size(), CV_8UC1, Scalar(0));
    ellipse(mask, Point(240, 180), Size(130, 100), 20, 0, 360, Scalar(255), FILLED);
    hideOutside(photograph, mask);
    return photograph;
}

/// How many of some points along the segment and 2 px beside it a mask hides.
int hiddenSamples(const Segment& segment, const Mat& mask)
{
    const Point2d d = segment.direction() / segment.length();
    int hidden = 0;
    for (int k = 0; k <= 100; ++k)
        for (int side = -2; side <= 2; side += 2)
        {
            const Point2d p = segment.at(k / 100.0) + side * Point2d(-d.y, d.x);
            const Point pixel(cvRound(p.x), cvRound(p.y));
            hidden += Rect(Point(), mask.size()).contains(pixel) && mask.at<uchar>(pixel) == 0;
        }
    return hidden;
}

TEST(Gcpw_Segments, hidden_pixels_have_none)
{
    const Photograph photograph = maskedNoise();
    Mat gray;
    cvtColor(photograph.image, gray, COLOR_BGR2GRAY);
    const std::vector<Segment> everywhere = detectSegments(gray, EVERYWHERE, SAME, 10);
    const std::vector<Segment> inside = detectSegments(gray, photograph.mask, SAME, 10);
    int hidden = 0;
    for (const Segment& s : everywhere)
        hidden += s.at(0.5).x > 5 && hiddenSamples(s, photograph.mask) > 0;
    EXPECT_GT(hidden, 50) << "the streaks have segments";
    EXPECT_FALSE(inside.empty());
    EXPECT_LT(inside.size(), everywhere.size());
    for (const Segment& s : inside)
        EXPECT_EQ(hiddenSamples(s, photograph.mask), 0) << s.start << s.end;
}

TEST(Gcpw_Segments, the_border_of_a_mask_is_none)
{
    const Mat gray = brightRectangle();
    const Mat mask = gray > 100;
    EXPECT_FALSE(detectSegments(gray, EVERYWHERE, SAME, 20).empty());
    EXPECT_TRUE(detectSegments(gray, mask, SAME, 20).empty());
}

TEST(Gcpw_Segments, what_leaves_the_mask_is_cut_to_its_longest_part_inside)
{
    Mat mask(140, 200, CV_8UC1, Scalar(255));
    mask.colRange(60, 70).setTo(0); // of the edges from 40 to 160 the part from 70 on is the longer one
    const std::vector<Segment> cut = detectSegments(brightRectangle(), mask, SAME, 20);
    int horizontal = 0;
    for (const Segment& s : cut)
    {
        EXPECT_GE(s.length(), 20);
        if (std::abs(s.direction().y) > std::abs(s.direction().x))
            continue;
        ++horizontal;
        EXPECT_NEAR(std::min(s.start.x, s.end.x), 73, 1.5);
        EXPECT_GT(std::max(s.start.x, s.end.x), 150);
    }
    EXPECT_GE(horizontal, 2);
}

TEST(Gcpw_Segments, a_mask_that_hides_nothing_changes_nothing)
{
    const std::vector<Segment> without = detectSegments(brightRectangle(), EVERYWHERE, SAME, 20);
    const std::vector<Segment> with = detectSegments(brightRectangle(), Mat(140, 200, CV_8UC1, Scalar(255)), SAME, 20);
    ASSERT_EQ(without.size(), with.size());
    for (size_t i = 0; i < with.size(); ++i)
        EXPECT_TRUE(samePlace(without[i], with[i]));
}

TEST(Gcpw_Segments, targets_are_looked_for_where_they_are_expected)
{
    const std::vector<Segment> a = {segment(10, 10, 90, 12), segment(20, 100, 60, 40)};
    std::vector<Segment> b;
    for (const Segment& s : a)
        b.push_back({s.start + Point2d(200, -30), s.end + Point2d(200, -30)});
    std::swap(b[0], b[1]);
    EXPECT_TRUE(matchSegments(a, b, stay, SegmentTolerance()).empty());
    const std::vector<LineMatch> found = matchSegments(
        a, b, [](Point2d p) { return p + Point2d(200, -30); }, SegmentTolerance());
    ASSERT_EQ(found.size(), 2u);
    for (const LineMatch& match : found)
    {
        EXPECT_EQ(match.b.start - match.a.start, Point2d(200, -30));
        EXPECT_NEAR(match.weight, 1, 1e-9);
    }
}

TEST(Gcpw_Segments, what_is_too_far_or_turned_or_beside_is_no_match)
{
    const std::vector<Segment> a = {segment(0, 0, 100, 0)};
    const auto targets = [&](const Segment& b) { return matchSegments(a, {b}, stay, SegmentTolerance()).size(); };
    EXPECT_EQ(targets(segment(0, 3.9, 100, 3.9)), 1u);
    EXPECT_EQ(targets(segment(0, 4.1, 100, 4.1)), 0u);
    EXPECT_EQ(targets(segment(100, 0, 0, 0)), 0u) << "the other hand";
    EXPECT_EQ(targets(segment(30, -2.5, 70, 2.5)), 0u) << "turned by 7 degrees";
    EXPECT_EQ(targets(segment(30, -1.5, 70, 1.5)), 1u) << "turned by 4 degrees";
    EXPECT_EQ(targets(segment(110, 0, 200, 0)), 0u) << "nothing in common";
    EXPECT_EQ(targets(segment(60, 0, 160, 0)), 0u) << "too little in common";
    EXPECT_EQ(targets(segment(40, 0, 140, 0)), 1u);
    EXPECT_EQ(targets(segment(20, 0, 40, 0)), 1u) << "a piece of it";
}

TEST(Gcpw_Segments, of_one_that_crosses_the_border_the_part_that_is_shown_is_matched)
{
    const std::vector<Segment> a = {segment(0, 0, 100, 0)};
    const auto shownFrom = [](double border)
    {
        return [border](Point2d p) { return p.x >= border ? std::optional<Point2d>(p) : std::nullopt; };
    };
    const std::vector<LineMatch> found = matchSegments(a, {segment(62, 0, 98, 0)}, shownFrom(60), SegmentTolerance());
    ASSERT_EQ(found.size(), 1u);
    EXPECT_TRUE(samePlace(found[0].a, segment(60, 0, 100, 0)));
    EXPECT_NEAR(found[0].weight, 0.9, 1e-9);
    EXPECT_TRUE(matchSegments(a, {segment(82, 0, 98, 0)}, shownFrom(81), SegmentTolerance()).empty()) << "less than 20 px";
    EXPECT_TRUE(matchSegments(a, {segment(0, 0, 100, 0)}, shownFrom(101), SegmentTolerance()).empty()) << "nothing";
}

TEST(Gcpw_Segments, each_is_used_once_by_its_best_match)
{
    const std::vector<Segment> a = {segment(0, 2, 100, 2), segment(0, 0.5, 100, 0.5)};
    const std::vector<Segment> b = {segment(0, 0, 100, 0)};
    const std::vector<LineMatch> found = matchSegments(a, b, stay, SegmentTolerance());
    ASSERT_EQ(found.size(), 1u);
    EXPECT_TRUE(samePlace(found[0].a, a[1]));
}

TEST(Gcpw_Segments, the_weight_is_the_share_in_common)
{
    const std::vector<LineMatch> found =
        matchSegments({segment(0, 0, 100, 0)}, {segment(25, 0, 75, 0)}, stay, SegmentTolerance());
    ASSERT_EQ(found.size(), 1u);
    EXPECT_NEAR(found[0].weight, 0.5, 1e-9);
}

}} // namespace
