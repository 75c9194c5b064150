// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#include "test_precomp.hpp"

#include <limits>
#include "opencv2/gcpw/aligner.hpp"
#include "refusal.hpp"
#include "scene.hpp"

namespace opencv_test
{
namespace
{

using namespace cv::gcpw;

const float NOT_A_NUMBER = std::numeric_limits<float>::quiet_NaN();
const float ENDLESS = std::numeric_limits<float>::infinity();

/// Two photographs that overlap, and what the aligner makes of them.
class Gcpw_AlignerInput : public ::testing::Test
{
protected:
    Alignment align(const std::vector<Point>& at,
                    const std::vector<Correspondences>& correspondences = std::vector<Correspondences>(),
                    const std::vector<KnownKeypoints>& keypoints = std::vector<KnownKeypoints>()) const
    {
        const std::vector<Mat> images = {scene.source(), scene.target()};
        return Aligner::create(params)->align(at, images, noArray(), correspondences, Progress(), keypoints);
    }

    static SceneOptions shifted()
    {
        SceneOptions options = smallScene();
        options.rough = slightHomography(64);
        return options;
    }

    Scene scene{shifted()};
    Params params;
    std::vector<Point> corners = {Point(66, -9), Point(0, 0)};
};

TEST_F(Gcpw_AlignerInput, moving_all_corners_moves_the_result_and_no_more)
{
    for (const double megapix : {0.6, 0.05})
    {
        params.workMegapix = megapix;
        const Alignment here = align(corners);
        ASSERT_TRUE(here.ok());
        ASSERT_GT(here.report().max_displacement_px, 0.5) << "nothing to do";
        for (const Point& shift : {Point(1000000, -500000), Point(-2000000000, 2000000000)})
        {
            const Alignment there = align({corners[0] + shift, corners[1] + shift});
            ASSERT_TRUE(there.ok());
            const double scale = here.canvasScale().width;
            for (int i = 0; i < 2; ++i)
            {
                const Mat back = there.image(i).mesh - Scalar(shift.x * scale, shift.y * scale);
                EXPECT_LE(cv::norm(back, here.image(i).mesh, NORM_INF), 1e-6) << shift;
                EXPECT_EQ(cv::norm(there.image(i).color, here.image(i).color, NORM_INF), 0) << shift;
            }
        }
    }
}

TEST_F(Gcpw_AlignerInput, a_canvas_that_is_too_large_is_refused)
{
    const int far = std::numeric_limits<int>::max();
    for (const Point& corner : {Point(far, 0), Point(-far - 1, 0), Point(0, far), Point(1 << 20, 0)})
    {
        expectRefused([&] { align({Point(0, 0), corner}); }, "canvas");
        expectRefused([&] { align({corner, Point(0, 0)}); }, "canvas");
    }
    expectRefused([&] { align({Point(far, far), Point(-far - 1, -far - 1)}); }, "canvas");
}

TEST_F(Gcpw_AlignerInput, a_canvas_that_repeats_inside_an_image_is_refused)
{
    for (const double period : {1e-9, 1.0, 100.0, 318.0})
    {
        params.canvasPeriod = period;
        expectRefused([&] { align(corners); }, "canvasPeriod");
    }
    params.canvasPeriod = 1e300;
    expectRefused([&] { align(corners); }, "canvasPeriod");
    params.canvasPeriod = 319; // an image all around
    EXPECT_EQ(align(corners).report().pairs.size(), 2u) << "on both sides";
    params.canvasPeriod = 1e9;
    EXPECT_TRUE(align(corners).ok());
}

TEST_F(Gcpw_AlignerInput, an_image_that_vanishes_at_the_working_resolution_is_refused)
{
    params.workMegapix = 1e-9;
    expectRefused([&] { align(corners); }, "workMegapix");
}

TEST_F(Gcpw_AlignerInput, correspondences_of_an_image_and_itself_are_refused)
{
    Correspondences item;
    item.a = item.b = 1;
    item.points_a = item.points_b = {Point2f(3, 3)};
    expectRefused([&] { align(corners, {item}); }, "correspondences[0]");
}

TEST_F(Gcpw_AlignerInput, correspondences_of_uneven_counts_are_refused_wherever_the_images_lie)
{
    Correspondences item;
    item.points_a.resize(3);
    expectRefused([&] { align(corners, {item}); }, "pairs of points");
    expectRefused([&] { align({Point(5000, 0), Point(0, 0)}, {item}); }, "pairs of points");
}

TEST_F(Gcpw_AlignerInput, points_that_are_not_finite_are_named)
{
    for (const float bad : {NOT_A_NUMBER, ENDLESS})
    {
        Correspondences item;
        item.points_a = {Point2f(1, 1), Point2f(2, bad)};
        item.points_b = {Point2f(1, 1), Point2f(2, 2)};
        expectRefused([&] { align(corners, {Correspondences(), item}); }, "correspondences[1].points_a[1]");
        item.points_a.swap(item.points_b);
        expectRefused([&] { align(corners, {item}); }, "correspondences[0].points_b[1]");

        std::vector<KnownKeypoints> known(2);
        known[1].points = {Point2f(5, 5), Point2f(bad, 5)};
        known[1].descriptors = Mat::zeros(2, 128, CV_32F);
        expectRefused([&] { align(corners, std::vector<Correspondences>(), known); }, "keypoints[1].points[1]");
        known[1].points[1].x = 5;
        known[1].descriptors.at<float>(1, 100) = bad;
        expectRefused([&] { align(corners, std::vector<Correspondences>(), known); }, "keypoints[1].descriptors");
    }
}

} // namespace
} // namespace opencv_test
