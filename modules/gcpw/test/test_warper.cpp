// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#include "test_precomp.hpp"

#include "rig_scene.hpp"

namespace opencv_test { namespace {

typedef cv::gcpw::GcpwWarper Creator;

std::vector<cv::detail::CameraParams> threeCameras()
{
    return {cameraAt(-0.4, 0.05, 0.02), cameraAt(0, -0.04, 0), cameraAt(0.45, 0.02, -0.03)};
}

/// Cameras of scans: R is the affine map from the canvas to the image, with a zoom of 1.2.
std::vector<cv::detail::CameraParams> threeScans()
{
    std::vector<cv::detail::CameraParams> cameras(3);
    for (int i = 0; i < 3; ++i)
    {
        cameras[i].focal = 1;
        cameras[i].ppx = cameras[i].ppy = 0;
        const float zoom = i == 1 ? 1.2F : 1.0F;
        cameras[i].R = (Mat_<float>(3, 3) << zoom, 0.05F, -90.F * static_cast<float>(i), -0.05F, zoom, 12, 0, 0, 1);
    }
    return cameras;
}

struct Base
{
    const char* name;
    Ptr<WarperCreator> creator;
    std::vector<cv::detail::CameraParams> cameras;
};

void PrintTo(const Base& base, std::ostream* out)
{
    *out << base.name;
}

class Gcpw_Warper : public testing::TestWithParam<Base>
{
};

TEST_P(Gcpw_Warper, corner_and_size_are_the_same_of_warp_warpRoi_and_buildMaps)
{
    const Base base = GetParam();
    const gcpw::Rig rig = bentRig(base.creator, base.cameras, 7);
    for (const double zoom : {0.4, 1.0, 1.7})
        for (const cv::detail::CameraParams& camera : rig.cameras)
        {
            const Ptr<cv::detail::RotationWarper> warper = Creator(base.creator, rig).create(static_cast<float>(rig.scale * zoom));
            const Size size(cvRound(RIG_IMAGE.width * zoom), cvRound(RIG_IMAGE.height * zoom));
            const Mat K = intrinsics(camera, zoom);
            const Rect roi = warper->warpRoi(size, K, camera.R);
            UMat picture;
            const Point corner = warper->warp(Mat(size, CV_8UC3, Scalar::all(9)), K, camera.R, INTER_LINEAR, BORDER_REFLECT, picture);
            Mat x_map;
            Mat y_map;
            const Rect maps = warper->buildMaps(size, K, camera.R, x_map, y_map);
            EXPECT_EQ(corner, roi.tl());
            EXPECT_EQ(picture.size(), roi.size());
            EXPECT_EQ(maps.tl(), roi.tl());
            EXPECT_EQ(x_map.size(), roi.size());
            EXPECT_EQ(y_map.size(), roi.size());
        }
}

TEST_P(Gcpw_Warper, warpPointBackward_undoes_warpPoint)
{
    const Base base = GetParam();
    const gcpw::Rig rig = bentRig(base.creator, base.cameras, 7);
    const Ptr<cv::detail::RotationWarper> warper = Creator(base.creator, rig).create(rig.scale);
    for (const cv::detail::CameraParams& camera : rig.cameras)
        for (int y = 0; y < RIG_IMAGE.height; y += 23)
            for (int x = 0; x < RIG_IMAGE.width; x += 19)
            {
                const Point2f p(static_cast<float>(x), static_cast<float>(y));
                const Point2f canvas = warper->warpPoint(p, intrinsics(camera), camera.R);
                EXPECT_LE(cv::norm(warper->warpPointBackward(canvas, intrinsics(camera), camera.R) - p), 0.01) << p;
            }
}

TEST_P(Gcpw_Warper, maps_say_what_warpPointBackward_says)
{
    const Base base = GetParam();
    const gcpw::Rig rig = bentRig(base.creator, base.cameras, 7);
    const Ptr<cv::detail::RotationWarper> warper = Creator(base.creator, rig).create(rig.scale);
    const cv::detail::CameraParams& camera = rig.cameras[1];
    Mat x_map;
    Mat y_map;
    const Point corner = warper->buildMaps(RIG_IMAGE, intrinsics(camera), camera.R, x_map, y_map).tl();
    int seen = 0;
    for (int y = 5; y < x_map.rows - 5; y += 11)
        for (int x = 5; x < x_map.cols - 5; x += 13)
        {
            const Point2f found(x_map.at<float>(y, x), y_map.at<float>(y, x));
            if (!Rect2f(0, 0, RIG_IMAGE.width, RIG_IMAGE.height).contains(found))
                continue;
            ++seen;
            EXPECT_LE(cv::norm(found - warper->warpPointBackward(Point2f(Point(x, y) + corner), intrinsics(camera), camera.R)), 0.02);
        }
    EXPECT_GT(seen, 300);
}

TEST_P(Gcpw_Warper, half_scale_is_half_of_full_scale)
{
    const Base base = GetParam();
    const gcpw::Rig rig = bentRig(base.creator, base.cameras, 7);
    const Creator creator(base.creator, rig);
    const Ptr<cv::detail::RotationWarper> full = creator.create(rig.scale);
    const Ptr<cv::detail::RotationWarper> half = creator.create(rig.scale / 2);
    for (const cv::detail::CameraParams& camera : rig.cameras)
        for (int y = 0; y < RIG_IMAGE.height; y += 37)
            for (int x = 0; x < RIG_IMAGE.width; x += 31)
            {
                const Point2f p(static_cast<float>(x), static_cast<float>(y));
                const Point2f large = full->warpPoint(p, intrinsics(camera), camera.R);
                const Point2f small = half->warpPoint(p * 0.5F, intrinsics(camera, 0.5), camera.R);
                EXPECT_LE(cv::norm(large * 0.5F - small), 0.5);
            }
}

TEST_P(Gcpw_Warper, masks_hold_no_pixel_outside_the_mesh)
{
    const Base base = GetParam();
    const gcpw::Rig rig = bentRig(base.creator, base.cameras, 7);
    const Ptr<cv::detail::RotationWarper> warper = Creator(base.creator, rig).create(rig.scale);
    const cv::detail::CameraParams& camera = rig.cameras[0];
    Mat mask;
    const Point corner = warper->warp(Mat(RIG_IMAGE, CV_8UC1, Scalar(255)), intrinsics(camera), camera.R, INTER_NEAREST, BORDER_CONSTANT, mask);
    const Rect2d inside(-0.51, -0.51, RIG_IMAGE.width + 0.02, RIG_IMAGE.height + 0.02);
    EXPECT_GT(countNonZero(mask), RIG_IMAGE.area() / 4);
    for (int y = 0; y < mask.rows; ++y)
        for (int x = 0; x < mask.cols; ++x)
            if (mask.at<uchar>(y, x))
            {
                const Point2d from = warper->warpPointBackward(Point2f(Point(x, y) + corner), intrinsics(camera), camera.R);
                ASSERT_TRUE(inside.contains(from)) << from;
            }
}

TEST_P(Gcpw_Warper, beside_the_mesh_a_mirrored_picture_goes_on_with_the_colours_next_to_it)
{
    const Base base = GetParam();
    const gcpw::Rig rig = bentRig(base.creator, base.cameras, 7);
    const Ptr<cv::detail::RotationWarper> warper = Creator(base.creator, rig).create(rig.scale);
    const cv::detail::CameraParams& camera = rig.cameras[0];
    Mat image(RIG_IMAGE, CV_8UC3, Scalar::all(140));
    image(Rect(0, 0, 2, 2)).setTo(Scalar::all(0)); // what a map without an answer would show
    Mat mirrored;
    Mat plain;
    warper->warp(image, intrinsics(camera), camera.R, INTER_LINEAR, BORDER_REFLECT, mirrored);
    warper->warp(image, intrinsics(camera), camera.R, INTER_LINEAR, BORDER_CONSTANT, plain);
    const Mat dark = mirrored.reshape(1) < 70;
    EXPECT_LE(countNonZero(dark), 100 * 3);
    EXPECT_GT(countNonZero(plain.reshape(1) == 0), countNonZero(dark));
}

TEST_P(Gcpw_Warper, warpBackward_undoes_warp)
{
    const Base base = GetParam();
    const gcpw::Rig rig = bentRig(base.creator, base.cameras, 7);
    const Ptr<cv::detail::RotationWarper> warper = Creator(base.creator, rig).create(rig.scale);
    const cv::detail::CameraParams& camera = rig.cameras[2];
    Mat image = photographOf(cameraAt(0), 0, 0);
    GaussianBlur(image, image, Size(), 2);
    Mat warped;
    warper->warp(image, intrinsics(camera), camera.R, INTER_LINEAR, BORDER_REFLECT, warped);
    Mat back;
    warper->warpBackward(warped, intrinsics(camera), camera.R, INTER_LINEAR, BORDER_REFLECT, RIG_IMAGE, back);
    const Rect middle(10, 10, RIG_IMAGE.width - 20, RIG_IMAGE.height - 20);
    EXPECT_LT(cv::norm(image(middle), back(middle), NORM_L1) / (3.0 * middle.area()), 1.0);
}

TEST_P(Gcpw_Warper, warpBackward_refuses_a_picture_of_another_size_with_a_rig_and_without)
{
    const Base base = GetParam();
    for (const double bend : {-1, 0, 7}) // -1: no rig at all
    {
        const Creator creator(base.creator, bend < 0 ? gcpw::Rig() : bentRig(base.creator, base.cameras, bend));
        const Ptr<cv::detail::RotationWarper> warper = creator.create(static_cast<float>(base.cameras[0].focal));
        const cv::detail::CameraParams& camera = base.cameras[1];
        const Size right = warper->warpRoi(RIG_IMAGE, intrinsics(camera), camera.R).size();
        Mat back;
        EXPECT_NO_THROW(warper->warpBackward(Mat(right, CV_8UC3, Scalar::all(9)), intrinsics(camera), camera.R, INTER_LINEAR, BORDER_REFLECT, RIG_IMAGE, back)) << bend;
        EXPECT_THROW(warper->warpBackward(Mat(right + Size(0, 5), CV_8UC3, Scalar::all(9)), intrinsics(camera), camera.R, INTER_LINEAR, BORDER_REFLECT, RIG_IMAGE, back), cv::Exception) << bend;
    }
}

const Base BASES[] = {{"spherical", makePtr<cv::SphericalWarper>(), threeCameras()},
                      {"cylindrical", makePtr<cv::CylindricalWarper>(), threeCameras()},
                      {"plane", makePtr<cv::PlaneWarper>(), threeCameras()},
                      {"affine", makePtr<cv::AffineWarper>(), threeScans()}};

INSTANTIATE_TEST_SUITE_P(bases, Gcpw_Warper, testing::ValuesIn(BASES));

TEST(Gcpw_Warper, an_undeformed_mesh_is_exactly_the_base_warper)
{
    const Ptr<WarperCreator> base = makePtr<cv::SphericalWarper>();
    const gcpw::Rig rig = bentRig(base, threeCameras(), 0);
    const Ptr<cv::detail::RotationWarper> plain = base->create(700);
    const Ptr<cv::detail::RotationWarper> warper = Creator(base, rig).create(700);
    const cv::detail::CameraParams& camera = rig.cameras[0];
    const Mat image = photographOf(camera, 0, 0);
    Mat pictures[2];
    const Point corner = plain->warp(image, intrinsics(camera), camera.R, INTER_LINEAR, BORDER_REFLECT, pictures[0]);
    EXPECT_EQ(warper->warp(image, intrinsics(camera), camera.R, INTER_LINEAR, BORDER_REFLECT, pictures[1]), corner);
    EXPECT_EQ(cv::norm(pictures[0], pictures[1], NORM_INF), 0);
    EXPECT_EQ(warper->warpRoi(RIG_IMAGE, intrinsics(camera), camera.R), plain->warpRoi(RIG_IMAGE, intrinsics(camera), camera.R));
    EXPECT_EQ(warper->warpPoint(Point2f(3, 4), intrinsics(camera), camera.R), plain->warpPoint(Point2f(3, 4), intrinsics(camera), camera.R));
}

TEST(Gcpw_Warper, an_unknown_camera_gets_the_base_warper)
{
    const Ptr<WarperCreator> base = makePtr<cv::CylindricalWarper>();
    const Ptr<cv::detail::RotationWarper> warper = Creator(base, bentRig(base, threeCameras(), 7)).create(500);
    const cv::detail::CameraParams other = cameraAt(0.2);
    EXPECT_EQ(warper->warpRoi(RIG_IMAGE, intrinsics(other), other.R), base->create(500)->warpRoi(RIG_IMAGE, intrinsics(other), other.R));
}

TEST(Gcpw_Warper, equal_rotations_are_told_apart_by_the_order_of_calls)
{
    const Ptr<WarperCreator> base = makePtr<cv::PlaneWarper>();
    const std::vector<cv::detail::CameraParams> cameras(2, cameraAt(0));
    const Ptr<cv::detail::RotationWarper> warper = Creator(base, bentRig(base, cameras, 9)).create(static_cast<float>(RIG_FOCAL));
    const Mat image = photographOf(cameras[0], 0, 0);
    std::vector<Mat> pictures(4);
    std::vector<Point> corners;
    std::vector<Rect> rois;
    for (int i = 0; i < 4; ++i)
        rois.push_back(warper->warpRoi(RIG_IMAGE, intrinsics(cameras[0]), cameras[0].R));
    for (Mat& picture : pictures)
    {
        corners.push_back(warper->warp(image, intrinsics(cameras[0]), cameras[0].R, INTER_LINEAR, BORDER_REFLECT, picture));
        Mat mask;
        warper->warp(Mat(RIG_IMAGE, CV_8UC1, Scalar(255)), intrinsics(cameras[0]), cameras[0].R, INTER_NEAREST, BORDER_CONSTANT, mask);
        EXPECT_EQ(mask.size(), picture.size());
    }
    for (size_t i = 0; i < 4; ++i)
        EXPECT_EQ(rois[i], Rect(corners[i], pictures[i].size()));
    EXPECT_NE(rois[0], rois[1]);
    EXPECT_EQ(rois[0], rois[2]);
    EXPECT_EQ(rois[1], rois[3]);
}

TEST(Gcpw_Warper, equal_rotations_of_gray_photographs_give_image_and_mask_one_mesh)
{
    const Ptr<WarperCreator> base = makePtr<cv::PlaneWarper>();
    const std::vector<cv::detail::CameraParams> cameras(2, cameraAt(0));
    const Creator creator(base, bentRig(base, cameras, 9));
    const Mat K = intrinsics(cameras[0]);
    const Mat image(RIG_IMAGE, CV_8UC1, Scalar(90));
    const Mat full(RIG_IMAGE, CV_8UC1, Scalar(255));
    for (const bool masks_later : {false, true})
    {
        // A new warper counts from the first image on, wherever the one before has stopped.
        Mat ignored;
        creator.create(static_cast<float>(RIG_FOCAL))->warp(image, K, cameras[0].R, INTER_LINEAR, BORDER_REFLECT, ignored);
        const Ptr<cv::detail::RotationWarper> warper = creator.create(static_cast<float>(RIG_FOCAL));
        std::vector<Rect> rois;
        std::vector<Rect> pictures;
        std::vector<Rect> masks;
        const auto warpMask = [&]
        {
            Mat mask;
            const Point corner = warper->warp(full, K, cameras[0].R, INTER_NEAREST, BORDER_CONSTANT, mask);
            masks.emplace_back(corner, mask.size());
        };
        for (int i = 0; i < 2; ++i)
        {
            rois.push_back(warper->warpRoi(RIG_IMAGE, K, cameras[0].R));
            Mat picture;
            const Point corner = warper->warp(image, K, cameras[0].R, INTER_LINEAR, BORDER_REFLECT, picture);
            pictures.emplace_back(corner, picture.size());
            if (!masks_later)
                warpMask();
        }
        for (int i = 0; masks_later && i < 2; ++i)
            warpMask();
        EXPECT_NE(rois[0], rois[1]);
        EXPECT_EQ(pictures, rois);
        EXPECT_EQ(masks, rois);
    }
}

TEST(Gcpw_Warper, a_tall_picture_may_be_warped_onto_itself)
{
    const Size tall(120, 2600);
    const Ptr<WarperCreator> base = makePtr<cv::AffineWarper>();
    std::vector<cv::detail::CameraParams> cameras(1);
    cameras[0].focal = 1;
    cameras[0].ppx = cameras[0].ppy = 0;
    cameras[0].R = Mat::eye(3, 3, CV_32F);
    gcpw::Rig rig = bentRig(base, cameras, 0);
    // Bent inside only: the picture keeps the image's size.
    gcpw::Alignment::Image image = rig.alignment.image(0);
    image.full_size = image.work_size = tall;
    for (int row = 0; row < image.mesh.rows; ++row)
        for (int col = 0; col < image.mesh.cols; ++col)
        {
            const Vec2d reference(col * tall.width / 8.0 - 0.5, row * tall.height / 6.0 - 0.5);
            image.rough.at<Vec2d>(row, col) = reference;
            image.mesh.at<Vec2d>(row, col) = reference + Vec2d(0, 40 * std::sin(CV_PI * row / 6));
        }
    rig.alignment = gcpw::Alignment({image}, Size2d(1, 1), gcpw::Report());
    const Ptr<cv::detail::RotationWarper> warper = Creator(base, rig).create(1);
    const Mat K = Mat::eye(3, 3, CV_32F);
    Mat picture(tall, CV_8UC1);
    for (int y = 0; y < tall.height; ++y)
        picture.row(y).setTo(Scalar((y * 37) % 251));
    Mat expected;
    warper->warp(picture, K, cameras[0].R, INTER_LINEAR, BORDER_CONSTANT, expected);
    ASSERT_EQ(expected.size(), tall);
    ASSERT_GT(cv::norm(expected, picture, NORM_INF), 0);
    UMat device = picture.getUMat(ACCESS_READ).clone();
    warper->warp(picture, K, cameras[0].R, INTER_LINEAR, BORDER_CONSTANT, picture);
    EXPECT_EQ(cv::norm(expected, picture, NORM_INF), 0);
    warper->warp(device, K, cameras[0].R, INTER_LINEAR, BORDER_CONSTANT, device);
    EXPECT_EQ(cv::norm(expected, device.getMat(ACCESS_READ), NORM_INF), 0);
}

TEST(Gcpw_Warper, an_image_across_the_seam_is_shown_on_both_sides)
{
    const Ptr<WarperCreator> base = makePtr<cv::SphericalWarper>();
    const double turn = cvRound(CV_PI * RIG_FOCAL) / RIG_FOCAL;
    const std::vector<cv::detail::CameraParams> cameras{cameraAt(turn), cameraAt(turn - 0.6)};
    const gcpw::Rig rig = bentRig(base, cameras, 5, {turn, 0});
    const Ptr<cv::detail::RotationWarper> warper = Creator(base, rig).create(rig.scale);
    const Mat K = intrinsics(cameras[0]);
    const Rect roi = warper->warpRoi(RIG_IMAGE, K, cameras[0].R);
    const Rect plain = base->create(rig.scale)->warpRoi(RIG_IMAGE, K, cameras[0].R);
    EXPECT_EQ(roi.x, plain.x);
    EXPECT_EQ(roi.width, plain.width);
    Mat mask;
    warper->warp(Mat(RIG_IMAGE, CV_8UC1, Scalar(255)), K, cameras[0].R, INTER_NEAREST, BORDER_CONSTANT, mask);
    ASSERT_EQ(mask.size(), roi.size());
    EXPECT_GT(countNonZero(mask.colRange(0, 120)), 120 * 200);
    EXPECT_GT(countNonZero(mask.colRange(mask.cols - 120, mask.cols)), 120 * 200);
    EXPECT_EQ(countNonZero(mask.colRange(mask.cols / 3, 2 * mask.cols / 3)), 0);
    for (int x = 10; x < RIG_IMAGE.width; x += 40)
    {
        const Point2f p(static_cast<float>(x), 150);
        EXPECT_LE(cv::norm(warper->warpPointBackward(warper->warpPoint(p, K, cameras[0].R), K, cameras[0].R) - p), 0.01);
    }
}

TEST(Gcpw_Warper, the_affine_warper_honours_a_change_of_scale)
{
    const Ptr<WarperCreator> base = makePtr<cv::AffineWarper>();
    const Ptr<cv::detail::RotationWarper> warper = Creator(base).create(1);
    const Mat map = (Mat_<float>(3, 3) << 1 / 1.2F, 0, 5, 0, 1 / 1.2F, -7, 0, 0, 1);
    const Rect roi = warper->warpRoi(Size(1000, 500), Mat::eye(3, 3, CV_32F), map);
    EXPECT_NEAR(roi.width, 1200, 2);
    EXPECT_NEAR(roi.height, 600, 2);
    const Point2f p(321, 123);
    const Point2f canvas = warper->warpPoint(p, Mat::eye(3, 3, CV_32F), map);
    EXPECT_NEAR(canvas.x, (321 - 5) * 1.2, 1e-3);
    EXPECT_LE(cv::norm(warper->warpPointBackward(canvas, Mat::eye(3, 3, CV_32F), map) - p), 1e-3);
}

TEST(Gcpw_Warper, cameras_may_be_doubles)
{
    const Ptr<WarperCreator> base = makePtr<cv::SphericalWarper>();
    const Ptr<cv::detail::RotationWarper> warper = Creator(base, bentRig(base, threeCameras(), 7)).create(400);
    const cv::detail::CameraParams camera = threeCameras()[0];
    Mat K;
    Mat R;
    intrinsics(camera).convertTo(K, CV_64F);
    camera.R.convertTo(R, CV_64F);
    EXPECT_EQ(warper->warpRoi(RIG_IMAGE, K, R), warper->warpRoi(RIG_IMAGE, intrinsics(camera), camera.R));
}

TEST(Gcpw_Warper, a_bad_camera_is_refused_before_anything_is_allocated)
{
    const Ptr<WarperCreator> base = makePtr<cv::SphericalWarper>();
    const cv::detail::CameraParams camera = cameraAt(0);
    Mat bad = camera.R.clone();
    bad.at<float>(1, 1) = std::numeric_limits<float>::quiet_NaN();
    const Ptr<cv::detail::RotationWarper> warper = Creator(base).create(400);
    EXPECT_THROW(warper->warpRoi(RIG_IMAGE, intrinsics(camera), bad), cv::Exception);
    const Ptr<cv::detail::RotationWarper> huge = Creator(base).create(1e6F);
    Mat picture;
    EXPECT_THROW(huge->warp(Mat(RIG_IMAGE, CV_8UC3), intrinsics(camera), camera.R, INTER_LINEAR, BORDER_REFLECT, picture), cv::Exception);
    EXPECT_TRUE(picture.empty());
}

}} // namespace
