// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#include "test_precomp.hpp"

#include "rig_scene.hpp"

namespace opencv_test
{
namespace
{

/// An image and a mask with a hole, warped in two calls and in one: no bit may differ.
void expectTheSame(const Ptr<WarperCreator>& base, const gcpw::Rig& rig, int type)
{
    const gcpw::GcpwWarper creator(base, rig);
    const double zoom = 1.2; // more than a strip of rows
    const Size size(cvRound(RIG_IMAGE.width * zoom), cvRound(RIG_IMAGE.height * zoom));
    Mat image(size, CV_8UC3);
    RNG(5).fill(image, RNG::UNIFORM, 0, 256);
    image.convertTo(image, type, type == CV_16UC3 ? 257 : 1);
    Mat mask(size, CV_8UC1, Scalar(255));
    mask(Rect(50, 60, 90, 40)).setTo(Scalar(0));
    const auto warper = creator.create(static_cast<float>(rig.scale * zoom)).dynamicCast<gcpw::GcpwRotationWarper>();
    ASSERT_TRUE(warper);
    for (const cv::detail::CameraParams& camera : rig.cameras)
    {
        const Mat K = intrinsics(camera, zoom);
        Mat picture;
        Mat shown;
        const Point corner = warper->warp(image, K, camera.R, INTER_LINEAR, BORDER_REFLECT, picture);
        warper->warp(mask, K, camera.R, INTER_NEAREST, BORDER_CONSTANT, shown);
        Mat at_once;
        Mat shown_at_once;
        EXPECT_EQ(warper->warpWithMask(image, mask, K, camera.R, at_once, shown_at_once), corner);
        EXPECT_EQ(warper->largeRoi(size, K, camera.R), Rect(corner, picture.size()));
        ASSERT_EQ(at_once.size(), picture.size());
        EXPECT_EQ(cv::norm(picture, at_once, NORM_INF), 0);
        EXPECT_EQ(cv::norm(shown, shown_at_once, NORM_INF), 0);
    }
}

TEST(Gcpw_WarpWithMask, has_the_pixels_of_two_calls_for_every_projection_bent_or_not)
{
    const std::vector<cv::detail::CameraParams> cameras{cameraAt(-0.3, 0.05, 0.02), cameraAt(0.2, -0.04, 0)};
    const std::vector<Ptr<WarperCreator>> bases{makePtr<cv::SphericalWarper>(),
                                                makePtr<cv::PlaneWarper>(),
                                                makePtr<cv::CylindricalWarper>(),
                                                makePtr<cv::StereographicWarper>(),
                                                makePtr<cv::FisheyeWarper>(),
                                                makePtr<cv::PaniniWarper>(2.F, 1.F),
                                                makePtr<cv::PaniniPortraitWarper>(2.F, 1.F),
                                                makePtr<cv::MercatorWarper>(),
                                                makePtr<cv::TransverseMercatorWarper>(),
                                                makePtr<cv::CompressedRectilinearWarper>(2.F, 1.F),
                                                makePtr<cv::CompressedRectilinearPortraitWarper>(2.F, 1.F)};
    for (size_t i = 0; i < bases.size(); ++i)
        for (const double bend : {0, 6})
        {
            SCOPED_TRACE(testing::Message() << "projection " << i << " bent by " << bend);
            expectTheSame(bases[i], bentRig(bases[i], cameras, bend), CV_8UC3);
        }
}

TEST(Gcpw_WarpWithMask, has_the_pixels_of_two_calls_with_sixteen_bits)
{
    const Ptr<WarperCreator> base = makePtr<cv::SphericalWarper>();
    expectTheSame(base, bentRig(base, {cameraAt(-0.3), cameraAt(0.2)}, 6), CV_16UC3);
}

TEST(Gcpw_WarpWithMask, has_the_pixels_of_two_calls_across_the_seam)
{
    const Ptr<WarperCreator> base = makePtr<cv::SphericalWarper>();
    const double turn = cvRound(CV_PI * RIG_FOCAL) / RIG_FOCAL;
    expectTheSame(base, bentRig(base, {cameraAt(turn), cameraAt(turn - 0.6)}, 5, {turn, 0}), CV_8UC3);
}

TEST(Gcpw_WarpWithMask, makes_pictures_wider_than_remap_takes)
{
    const Ptr<WarperCreator> base = makePtr<cv::SphericalWarper>();
    const auto warper = gcpw::GcpwWarper(base).create(6000).dynamicCast<gcpw::GcpwRotationWarper>();
    const cv::detail::CameraParams camera = cameraAt(CV_PI); // across the seam: all around
    const Mat K = intrinsics(camera);
    const Rect roi = warper->largeRoi(RIG_IMAGE, K, camera.R);
    EXPECT_GT(roi.width, 32767);
    EXPECT_THROW(warper->warpRoi(RIG_IMAGE, K, camera.R), cv::Exception);
    Mat picture;
    Mat shown;
    // A narrow band of the photograph is enough.
    const Mat image(Size(RIG_IMAGE.width, 6), CV_8UC3, Scalar(10, 20, 30));
    warper->warpWithMask(image, Mat(image.size(), CV_8UC1, Scalar(255)), K, camera.R, picture, shown);
    ASSERT_GT(picture.cols, 32767);
    EXPECT_GT(countNonZero(shown.colRange(0, 500)), 0);
    EXPECT_GT(countNonZero(shown.colRange(shown.cols - 500, shown.cols)), 0);
    EXPECT_EQ(picture.at<Vec3b>(picture.rows / 2, picture.cols / 2), Vec3b(10, 20, 30));
}

TEST(Gcpw_WarpWithMask, refuses_a_mask_of_another_size)
{
    const Ptr<WarperCreator> base = makePtr<cv::SphericalWarper>();
    const auto warper = gcpw::GcpwWarper(base).create(400).dynamicCast<gcpw::GcpwRotationWarper>();
    const Mat image(RIG_IMAGE, CV_8UC3, Scalar::all(9));
    Mat picture;
    Mat shown;
    EXPECT_THROW(
        warper->warpWithMask(image, Mat(3, 4, CV_8UC1), intrinsics(cameraAt(0)), cameraAt(0).R, picture, shown),
        cv::Exception);
}

} // namespace
} // namespace opencv_test
