// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#include "test_precomp.hpp"

#include "rig_scene.hpp"

namespace opencv_test { namespace {

const float SCALE = 380;

TEST(Gcpw_PythonWarper, it_does_what_the_rotation_warper_does)
{
    const std::vector<cv::detail::CameraParams> cameras{cameraAt(-0.3), cameraAt(0.3, 0.1)};
    const gcpw::Rig rig = bentRig(makePtr<cv::SphericalWarper>(), cameras, 6);
    gcpw::PyGcpwWarper warper("spherical", SCALE, rig);
    gcpw::GcpwRotationWarper expected(makePtr<cv::detail::SphericalWarper>(SCALE), rig);
    const Mat K = intrinsics(cameras[1]);
    const Mat R = cameras[1].R;
    const Mat image = photographOf(cameras[1], 0, 0);

    EXPECT_EQ(warper.getScale(), SCALE);
    EXPECT_EQ(warper.warpRoi(image.size(), K, R), expected.warpRoi(image.size(), K, R));
    EXPECT_EQ(warper.warpPoint(Point2f(20, 30), K, R), expected.warpPoint(Point2f(20, 30), K, R));
    EXPECT_EQ(warper.warpPointBackward(Point2f(100, 30), K, R), expected.warpPointBackward(Point2f(100, 30), K, R));
    Mat maps[4];
    EXPECT_EQ(warper.buildMaps(image.size(), K, R, maps[0], maps[1]), expected.buildMaps(image.size(), K, R, maps[2], maps[3]));
    EXPECT_EQ(cv::norm(maps[0], maps[2], NORM_INF), 0);
    EXPECT_EQ(cv::norm(maps[1], maps[3], NORM_INF), 0);
    Mat warped[2];
    EXPECT_EQ(warper.warp(image, K, R, INTER_LINEAR, BORDER_REFLECT, warped[0]),
              expected.warp(image, K, R, INTER_LINEAR, BORDER_REFLECT, warped[1]));
    EXPECT_EQ(cv::norm(warped[0], warped[1], NORM_INF), 0);
    Mat back[2];
    warper.warpBackward(warped[0], K, R, INTER_LINEAR, BORDER_CONSTANT, image.size(), back[0]);
    expected.warpBackward(warped[1], K, R, INTER_LINEAR, BORDER_CONSTANT, image.size(), back[1]);
    EXPECT_EQ(cv::norm(back[0], back[1], NORM_INF), 0);

    // The mesh counts: without the rig the image lies elsewhere.
    gcpw::PyGcpwWarper plain("spherical", SCALE);
    EXPECT_NE(warper.warpPoint(Point2f(20, 30), K, R), plain.warpPoint(Point2f(20, 30), K, R));
    warper.setScale(2 * SCALE);
    EXPECT_EQ(warper.getScale(), 2 * SCALE);
}

TEST(Gcpw_PythonWarper, unknown_names_and_scales_that_are_not_positive_are_refused)
{
    EXPECT_THROW(gcpw::PyGcpwWarper("sperical", SCALE), cv::Exception);
    for (const float scale : {0.F, -1.F, std::numeric_limits<float>::quiet_NaN()})
    {
        EXPECT_THROW(gcpw::PyGcpwWarper("spherical", scale), cv::Exception);
        gcpw::PyGcpwWarper warper("spherical", SCALE);
        EXPECT_THROW(warper.setScale(scale), cv::Exception);
    }
}

}} // namespace opencv_test
