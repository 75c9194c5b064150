// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#include "test_precomp.hpp"

#include "registration/keypoints.hpp"
#include "scene.hpp"

namespace opencv_test { namespace {

using namespace cv::gcpw;

const int LENGTH = 128;

Mat randomDescriptors(int count, uint64_t seed)
{
    Mat descriptors(count, LENGTH, CV_8UC1);
    seeded(seed).fill(descriptors, RNG::UNIFORM, 0, 256);
    return descriptors;
}

/// Keypoints on a grid 50 px apart with decorrelation descriptors.
Keypoints someKeypoints(int count, uint64_t seed)
{
    Keypoints keypoints;
    keypoints.descriptors = randomDescriptors(count, seed);
    for (int i = 0; i < count; ++i)
        keypoints.points.emplace_back(50.0 * (i % 10), 50.0 * (i / 10));
    return keypoints;
}

/// The same keypoints in the order given.
Keypoints reordered(const Keypoints& keypoints, const std::vector<int>& order)
{
    Keypoints result;
    for (const int i : order)
    {
        result.points.push_back(keypoints.points[i]);
        result.descriptors.push_back(keypoints.descriptors.row(i));
    }
    return result;
}

std::vector<int> reversedOrder(int count)
{
    std::vector<int> order(count);
    for (int i = 0; i < count; ++i)
        order[i] = count - 1 - i;
    return order;
}

/// A descriptor at a known squared distance: one entry changed by `offset`.
void copyWithOffset(const Mat& from, Mat to, int entry, int offset)
{
    from.copyTo(to);
    uchar& value = to.at<uchar>(0, entry);
    value = static_cast<uchar>(value < 128 ? value + offset : value - offset);
}

Point2d stay(Point2d p)
{
    return p;
}

TEST(Gcpw_Keypoints, equal_descriptors_find_each_other_in_any_order)
{
    const Keypoints a = someKeypoints(40, 1);
    const Keypoints b = reordered(a, reversedOrder(40));
    const std::vector<KeypointMatch> found = matchEverywhere(a, b, 1000, 0.8);
    ASSERT_EQ(found.size(), 40u);
    for (const KeypointMatch& match : found)
    {
        EXPECT_EQ(match.b, 39 - match.a);
        EXPECT_EQ(match.ratio, 0);
    }
}

TEST(Gcpw_Keypoints, unlike_descriptors_do_not_pass_the_ratio_test)
{
    EXPECT_LT(matchEverywhere(someKeypoints(40, 1), someKeypoints(40, 2), 1000, 0.8).size(), 3u);
}

TEST(Gcpw_Keypoints, the_ratio_is_that_of_the_distances)
{
    Keypoints a = someKeypoints(2, 3);
    Keypoints b = someKeypoints(2, 3);
    copyWithOffset(a.descriptors.row(0), b.descriptors.row(0), 5, 30);
    copyWithOffset(a.descriptors.row(0), b.descriptors.row(1), 5, 40);
    const std::vector<KeypointMatch> found = matchEverywhere(a, b, 1000, 0.8);
    ASSERT_EQ(found.size(), 1u);
    EXPECT_NEAR(found[0].ratio, 0.75, 1e-6);
    EXPECT_TRUE(matchEverywhere(a, b, 1000, 0.74).empty());
}

TEST(Gcpw_Keypoints, matches_are_mutual)
{
    // Both keypoints of a resemble b's first one, the second more so.
    Keypoints a = someKeypoints(2, 4);
    const Keypoints b = someKeypoints(2, 4);
    copyWithOffset(b.descriptors.row(0), a.descriptors.row(0), 7, 20);
    copyWithOffset(b.descriptors.row(0), a.descriptors.row(1), 7, 10);
    for (const auto& found : {matchEverywhere(a, b, 1000, 0.9), matchNearby(a, b, stay, 200, 0.9)})
    {
        ASSERT_EQ(found.size(), 1u);
        EXPECT_EQ(found[0].a, 1);
        EXPECT_EQ(found[0].b, 0);
    }
}

TEST(Gcpw_Keypoints, only_the_strongest_are_matched_everywhere)
{
    const Keypoints a = someKeypoints(40, 5);
    const std::vector<KeypointMatch> found = matchEverywhere(a, a, 10, 0.8);
    ASSERT_EQ(found.size(), 10u);
    for (const KeypointMatch& match : found)
        EXPECT_LT(match.a, 10);
    EXPECT_TRUE(matchEverywhere(a, a, 1, 0.8).empty()) << "a ratio needs two";
    EXPECT_TRUE(matchEverywhere(a, Keypoints(), 10, 0.8).empty());
}

TEST(Gcpw_Keypoints, nearby_is_measured_from_where_the_keypoint_is_expected)
{
    const Keypoints a = someKeypoints(30, 6);
    Keypoints b = a;
    for (Point2d& p : b.points)
        p += Point2d(300, 7);
    const auto expected = [](Point2d p) { return p + Point2d(300, 0); };
    EXPECT_EQ(matchNearby(a, b, expected, 7.1, 0.8).size(), 30u);
    EXPECT_TRUE(matchNearby(a, b, expected, 6.9, 0.8).empty());
    EXPECT_TRUE(matchNearby(a, b, stay, 7.1, 0.8).size() < 30u);
    const auto nowhere = [](Point2d) { return Point2d(-1e6, -1e6); };
    EXPECT_TRUE(matchNearby(a, b, nowhere, 50, 0.8).empty());
    EXPECT_TRUE(matchNearby(Keypoints(), b, stay, 50, 0.8).empty());
    EXPECT_TRUE(matchNearby(a, Keypoints(), stay, 50, 0.8).empty());
}

TEST(Gcpw_Keypoints, a_rival_on_the_same_spot_does_not_fail_the_ratio_test)
{
    Keypoints a = someKeypoints(1, 7);
    Keypoints b = someKeypoints(2, 7);
    copyWithOffset(a.descriptors.row(0), b.descriptors.row(0), 3, 20);
    copyWithOffset(a.descriptors.row(0), b.descriptors.row(1), 3, 21);
    b.points[1] = b.points[0] + Point2d(2, 0); // the same spot at another scale
    EXPECT_EQ(matchNearby(a, b, stay, 20, 0.8).size(), 1u);
    b.points[1] = b.points[0] + Point2d(5, 0); // a repeated structure
    EXPECT_TRUE(matchNearby(a, b, stay, 20, 0.8).empty());
}

TEST(Gcpw_Keypoints, matches_carry_the_points)
{
    const Keypoints a = someKeypoints(20, 8);
    const Keypoints b = reordered(a, reversedOrder(20));
    const std::vector<PointMatch> points = toPointMatches(a, b, matchEverywhere(a, b, 100, 0.8));
    ASSERT_EQ(points.size(), 20u);
    for (const PointMatch& match : points)
        EXPECT_EQ(match.a, match.b);
}

TEST(Gcpw_Keypoints, one_thread_and_many_find_the_same)
{
    const Scene scene{SceneOptions()};
    Mat gray[2];
    cv::cvtColor(scene.source(), gray[0], COLOR_BGR2GRAY);
    cv::cvtColor(scene.target(), gray[1], COLOR_BGR2GRAY);
    const int threads = getNumThreads();
    std::vector<KeypointMatch> matches[2];
    Keypoints keypoints[2];
    for (int run = 0; run < 2; ++run)
    {
        setNumThreads(run == 0 ? threads : 1);
        Keypoints a = detectKeypoints(gray[0], Mat(), Size2d(1, 1), 0.005);
        const Keypoints b = detectKeypoints(gray[1], Mat(), Size2d(1, 1), 0.005);
        const auto expected = [&](Point2d p) { return scene.canvasAt(p); };
        matches[run] = matchNearby(a, b, expected, 10, 0.85);
        keypoints[run] = a;
    }
    setNumThreads(threads);
    EXPECT_EQ(keypoints[0].points, keypoints[1].points);
    EXPECT_EQ(cv::norm(keypoints[0].descriptors, keypoints[1].descriptors, NORM_INF), 0);
    ASSERT_EQ(matches[0].size(), matches[1].size());
    EXPECT_GT(matches[0].size(), 300u);
    for (size_t i = 0; i < matches[0].size(); ++i)
    {
        EXPECT_EQ(matches[0][i].a, matches[1][i].a);
        EXPECT_EQ(matches[0][i].b, matches[1][i].b);
    }
}

TEST(Gcpw_Keypoints, positions_are_reference_pixels)
{
    const Scene scene{SceneOptions()};
    Mat gray;
    cv::cvtColor(scene.target(), gray, COLOR_BGR2GRAY);
    const Keypoints same = detectKeypoints(gray, Mat(), Size2d(1, 1), 0.02);
    const Keypoints scaled = detectKeypoints(gray, Mat(), Size2d(0.5, 0.25), 0.02);
    ASSERT_GT(same.points.size(), 50u);
    ASSERT_EQ(same.points.size(), scaled.points.size());
    EXPECT_EQ(same.descriptors.rows, static_cast<int>(same.points.size()));
    for (size_t i = 0; i < same.points.size(); ++i)
    {
        EXPECT_NEAR(scaled.points[i].x, (same.points[i].x + 0.5) * 0.5 - 0.5, 1e-9);
        EXPECT_NEAR(scaled.points[i].y, (same.points[i].y + 0.5) * 0.25 - 0.5, 1e-9);
    }
}

TEST(Gcpw_Keypoints, outside_the_mask_there_are_none)
{
    const Scene scene{SceneOptions()};
    Mat gray;
    cv::cvtColor(scene.target(), gray, COLOR_BGR2GRAY);
    Mat mask(gray.size(), CV_8UC1, Scalar(255));
    mask.colRange(0, 200).setTo(0);
    const Keypoints all = detectKeypoints(gray, Mat(), Size2d(1, 1), 0.02);
    const Keypoints inside = detectKeypoints(gray, mask, Size2d(1, 1), 0.02);
    EXPECT_GT(inside.points.size(), 50u);
    EXPECT_LT(inside.points.size(), all.points.size());
    EXPECT_EQ(inside.descriptors.rows, static_cast<int>(inside.points.size()));
    for (const Point2d& p : inside.points)
        EXPECT_GT(p.x, 198.5);
}

TEST(Gcpw_Keypoints, a_flat_picture_has_none)
{
    const Keypoints none = detectKeypoints(Mat(100, 100, CV_8UC1, Scalar(70)), Mat(), Size2d(1, 1), 0.005);
    EXPECT_TRUE(none.points.empty());
}

}} // namespace
