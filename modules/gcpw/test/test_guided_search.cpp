// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#include "test_precomp.hpp"

#include "registration/corners.hpp"
#include "registration/guided_search.hpp"
#include "registration/window_tracker.hpp"
#include "scene.hpp"

namespace opencv_test
{
namespace
{

using namespace cv::gcpw;

const int LEVELS = 4;

/// The texture of scenes, in gray, as an affine view shows it.
Mat viewOf(const Matx23d& texture_from_pixel, double gain = 1, double bias = 0)
{
    const Texture texture(5);
    Mat gray(240, 320, CV_8UC1);
    for (int y = 0; y < gray.rows; ++y)
        for (int x = 0; x < gray.cols; ++x)
        {
            const Vec2d p = texture_from_pixel * Vec3d(x, y, 1);
            const Vec3d color = texture.at(Point2d(p));
            gray.at<uchar>(y, x) =
                saturate_cast<uchar>(255 * (gain * (0.2 * color[0] + 0.5 * color[1] + 0.3 * color[2]) + bias));
        }
    return gray;
}

const Matx23d HERE(1, 0, 0, 0, 1, 0);

GrayPyramid pyramidOf(const Mat& gray, const Mat& mask = Mat())
{
    return GrayPyramid(gray, mask, LEVELS);
}

/// Matches of all corners of HERE with another view, where the truth is known.
struct Search
{
    std::vector<Point> corners;
    std::vector<PointMatch> matches;
    double most = 0;   ///< px from the truth, of 95 of 100; a mirrored border may look like what lies beyond it
    double median = 0; ///< px

    Search(const GrayPyramid& a, const GrayPyramid& b, const Matx23d& b_from_a, const Prediction& prediction)
        : corners(findCorners(a.gray(), a.mask(), 12)), matches(searchCorners(a, corners, b, prediction, LEVELS))
    {
        std::vector<double> errors;
        for (const PointMatch& match : matches)
            errors.push_back(cv::norm(match.b - Point2d(Vec2d(b_from_a * Vec3d(match.a.x, match.a.y, 1)))));
        std::sort(errors.begin(), errors.end());
        if (errors.empty())
            return;
        median = errors[errors.size() / 2];
        most = errors[errors.size() * 95 / 100];
    }
};

Prediction shiftedBy(Point2d shift)
{
    return [shift](Point2d p) -> std::optional<Point2d> { return p + shift; };
}

Matx23d inverse(const Matx23d& m)
{
    const Matx22d linear = Matx22d(m(0, 0), m(0, 1), m(1, 0), m(1, 1)).inv();
    const Vec2d shift = -(linear * Vec2d(m(0, 2), m(1, 2)));
    return {linear(0, 0), linear(0, 1), shift[0], linear(1, 0), linear(1, 1), shift[1]};
}

TEST(Gcpw_GuidedSearch, finds_a_shift_that_was_not_expected)
{
    const Matx23d b_from_a(1, 0, 17.3, 0, 1, -8.6);
    const Search search(pyramidOf(viewOf(HERE)), pyramidOf(viewOf(inverse(b_from_a))), b_from_a, shiftedBy(Point2d()));
    EXPECT_GT(search.matches.size(), search.corners.size() / 3);
    EXPECT_LT(search.median, 0.05);
    EXPECT_LT(search.most, 0.3);
}

TEST(Gcpw_GuidedSearch, does_not_mind_gain_and_bias)
{
    const Matx23d b_from_a(1, 0, 6.4, 0, 1, 5.2);
    const Search search(pyramidOf(viewOf(HERE)), pyramidOf(viewOf(inverse(b_from_a), 0.5, 0.3)), b_from_a,
                        shiftedBy(Point2d()));
    EXPECT_GT(search.matches.size(), search.corners.size() / 3);
    EXPECT_LT(search.median, 0.1);
}

TEST(Gcpw_GuidedSearch, looks_through_the_expected_turn_and_zoom)
{
    const Matx23d b_from_a(0.9, -0.9, 200, 0.9, 0.9, -60); // 45 degrees, 1.27 times as large
    const Prediction expected = [&](Point2d p) -> std::optional<Point2d>
    { return Point2d(Vec2d(b_from_a * Vec3d(p.x, p.y, 1))) + Point2d(3, -2); };
    const GrayPyramid a = pyramidOf(viewOf(HERE));
    const GrayPyramid b = pyramidOf(viewOf(inverse(b_from_a)));
    const Search search(a, b, b_from_a, expected);
    EXPECT_GT(search.matches.size(), 40u);
    EXPECT_LT(search.most, 0.3);
    const Search blind(a, b, b_from_a,
                       [&](Point2d p) -> std::optional<Point2d>
                       {
        // The same places, but upright windows.
        const Point2d whole(8 * cvRound(p.x / 8), 8 * cvRound(p.y / 8));
        return *expected(whole) + p - whole;
    });
    EXPECT_LT(blind.matches.size(), search.matches.size() / 4);
}

TEST(Gcpw_GuidedSearch, keeps_nothing_of_what_the_other_image_does_not_show)
{
    Mat elsewhere = viewOf(Matx23d(1, 0, 5000, 0, 1, 5000));
    const Search search(pyramidOf(viewOf(HERE)), pyramidOf(elsewhere), HERE, shiftedBy(Point2d()));
    EXPECT_GT(search.corners.size(), 100u);
    EXPECT_LT(search.matches.size(), search.corners.size() / 50);
    const std::vector<PointMatch> none = searchCorners(
        pyramidOf(elsewhere), search.corners, pyramidOf(elsewhere), [](Point2d) { return std::optional<Point2d>(); },
        LEVELS);
    EXPECT_TRUE(none.empty());
}

TEST(Gcpw_GuidedSearch, matches_lie_inside_both_masks)
{
    Mat left(240, 320, CV_8UC1, Scalar(255));
    left.colRange(200, 320).setTo(0);
    Mat right(240, 320, CV_8UC1, Scalar(255));
    right.colRange(0, 100).setTo(0);
    const Search search(pyramidOf(viewOf(HERE), left), pyramidOf(viewOf(HERE), right), HERE, shiftedBy(Point2d()));
    EXPECT_GT(search.matches.size(), 20u);
    for (const PointMatch& match : search.matches)
    {
        EXPECT_LT(match.a.x, 200);
        EXPECT_GT(match.b.x, 99);
    }
}

TEST(Gcpw_GuidedSearch, gives_the_same_bits_with_any_number_of_threads)
{
    const Matx23d b_from_a(1, 0, 4.1, 0, 1, 3.3);
    const GrayPyramid a = pyramidOf(viewOf(HERE));
    const GrayPyramid b = pyramidOf(viewOf(inverse(b_from_a)));
    const int threads = getNumThreads();
    std::vector<PointMatch> found[2];
    for (int k = 0; k < 2; ++k)
    {
        setNumThreads(k == 0 ? 1 : 3);
        found[k] = Search(a, b, b_from_a, shiftedBy(Point2d())).matches;
    }
    setNumThreads(threads);
    ASSERT_EQ(found[0].size(), found[1].size());
    for (size_t i = 0; i < found[0].size(); ++i)
        EXPECT_TRUE(found[0][i].a == found[1][i].a && found[0][i].b == found[1][i].b);
}

TEST(Gcpw_WindowTracker, refuses_windows_without_texture)
{
    const GrayPyramid flat = pyramidOf(Mat(240, 320, CV_8UC1, Scalar(90)));
    Mat step(240, 320, CV_8UC1, Scalar(60));
    step.colRange(160, 320).setTo(180); // an edge says nothing about its own direction
    ExpectedPlace there;
    there.at = Point2d(160, 120);
    FoundPlace found;
    EXPECT_FALSE(follow(flat, there.at, flat, there, 1, found));
    EXPECT_FALSE(follow(pyramidOf(step), there.at, pyramidOf(step), there, 1, found));
}

TEST(Gcpw_WindowTracker, refuses_maps_that_mirror_and_places_beyond_the_image)
{
    const GrayPyramid pyramid = pyramidOf(viewOf(HERE));
    const Point corner = findCorners(pyramid.gray(), Mat(), 60)[5];
    ExpectedPlace there;
    there.at = corner;
    FoundPlace found;
    ASSERT_TRUE(follow(pyramid, corner, pyramid, there, LEVELS, found));
    EXPECT_LT(cv::norm(found.at - Point2d(corner)), 1e-3);
    EXPECT_GT(found.correlation, 0.999);
    there.map = Matx22d(-1, 0, 0, 1);
    EXPECT_FALSE(follow(pyramid, corner, pyramid, there, LEVELS, found));
    there.map = Matx22d::eye();
    for (const Point2d& beyond : {Point2d(-500, 10), Point2d(1e300, 0), Point2d(std::nan(""), 0)})
    {
        there.at = beyond;
        EXPECT_FALSE(follow(pyramid, corner, pyramid, there, LEVELS, found));
    }
}

TEST(Gcpw_Corners, are_the_strongest_of_their_squares)
{
    Mat gray(100, 100, CV_8UC1, Scalar(50));
    gray(Rect(30, 30, 40, 40)).setTo(200);
    const std::vector<Point> corners = findCorners(gray, Mat(), 50);
    ASSERT_EQ(corners.size(), 4u);
    const Point truth[] = {Point(30, 30), Point(69, 30), Point(30, 69), Point(69, 69)};
    for (int k = 0; k < 4; ++k)
        EXPECT_LE(cv::norm(corners[k] - truth[k]), 2.0);
}

TEST(Gcpw_Corners, stay_inside_the_mask)
{
    const Mat gray = viewOf(HERE);
    Mat mask(gray.size(), CV_8UC1, Scalar(0));
    mask(Rect(100, 60, 80, 90)).setTo(255);
    const std::vector<Point> corners = findCorners(gray, mask, 10);
    EXPECT_GT(corners.size(), 10u);
    for (const Point& corner : corners)
        EXPECT_TRUE(Rect(103, 63, 74, 84).contains(corner)) << corner;
    EXPECT_TRUE(findCorners(gray, Mat::zeros(gray.size(), CV_8UC1), 10).empty());
    EXPECT_TRUE(findCorners(Mat::zeros(5, 5, CV_8UC1), Mat(), 10).empty());
}

} // namespace
} // namespace opencv_test
