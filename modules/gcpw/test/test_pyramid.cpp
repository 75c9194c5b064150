// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#include "test_precomp.hpp"

#include "imaging/pyramid.hpp"
#include "seeded.hpp"

namespace opencv_test { namespace {

using namespace cv::gcpw;

TEST(Gcpw_Pyramid, the_finest_level_is_the_image_in_ycrcb)
{
    Mat image(40, 50, CV_8UC3);
    seeded(1).fill(image, RNG::UNIFORM, 0, 256);
    Mat ycrcb;
    cv::cvtColor(image, ycrcb, COLOR_BGR2YCrCb);
    const std::vector<PyramidLevel> pyramid = buildPyramid(image, Mat(), 1);
    ASSERT_EQ(pyramid.size(), 1u);
    EXPECT_EQ(pyramid[0].scale, 1);
    ASSERT_EQ(pyramid[0].pixels.type(), CV_32FC4);
    for (int y = 0; y < image.rows; ++y)
        for (int x = 0; x < image.cols; ++x)
        {
            for (int c = 0; c < 3; ++c)
                ASSERT_NEAR(pyramid[0].at(x, y)[c], ycrcb.at<Vec3b>(y, x)[c] / 255.0, 1e-6);
            ASSERT_EQ(pyramid[0].at(x, y)[3], 1);
        }
}

TEST(Gcpw_Pyramid, pixel_p_of_level_l_shows_reference_pixel_p_times_two_to_the_l)
{
    // Blurring keeps a linear ramp where it is, so that each level tells where its pixels lie.
    Mat ramp(128, 160, CV_8UC3);
    for (int y = 0; y < ramp.rows; ++y)
        for (int x = 0; x < ramp.cols; ++x)
            ramp.at<Vec3b>(y, x) = Vec3b::all(static_cast<uchar>(x + y / 2));
    const std::vector<PyramidLevel> pyramid = buildPyramid(ramp, Mat(), 3);
    ASSERT_EQ(pyramid.size(), 3u);
    for (size_t l = 0; l < pyramid.size(); ++l)
    {
        const int step = 1 << l;
        EXPECT_EQ(pyramid[l].scale, step);
        for (int y = 4; y + 4 < pyramid[l].pixels.rows; ++y)
            for (int x = 4; x + 4 < pyramid[l].pixels.cols; ++x)
                ASSERT_NEAR(255 * pyramid[l].at(x, y)[0], x * step + y * step / 2.0, 0.51) << l << Point(x, y);
    }
}

TEST(Gcpw_Pyramid, levels_too_small_to_say_anything_are_not_made)
{
    const auto levelsOf = [](Size size) { return buildPyramid(Mat(size, CV_8UC3, Scalar::all(7)), Mat(), 8).size(); };
    EXPECT_EQ(levelsOf(Size(1, 1)), 1u);
    EXPECT_EQ(levelsOf(Size(31, 500)), 1u);
    EXPECT_EQ(levelsOf(Size(32, 500)), 2u);
    EXPECT_EQ(levelsOf(Size(640, 480)), 5u);
}

TEST(Gcpw_Pyramid, the_mask_is_the_fourth_channel)
{
    const Mat image(64, 64, CV_8UC3, Scalar::all(100));
    Mat mask(64, 64, CV_8UC1, Scalar(255));
    mask(Rect(0, 0, 32, 64)).setTo(0);
    const std::vector<PyramidLevel> pyramid = buildPyramid(image, mask, 2);
    ASSERT_EQ(pyramid.size(), 2u);
    EXPECT_EQ(pyramid[0].at(31, 10)[3], 0);
    EXPECT_EQ(pyramid[0].at(32, 10)[3], 1);
    EXPECT_NEAR(pyramid[1].at(8, 10)[3], 0, 1e-6);
    EXPECT_NEAR(pyramid[1].at(24, 10)[3], 1, 1e-6);
    EXPECT_LT(pyramid[1].at(16, 10)[3], 0.98F) << "a pixel that mixes in what is outside";
}

TEST(Gcpw_Pyramid, images_of_another_type_and_masks_of_another_size_are_refused)
{
    const Mat image(32, 32, CV_8UC3, Scalar::all(0));
    EXPECT_THROW(buildPyramid(Mat(32, 32, CV_8UC1, Scalar(0)), Mat(), 1), cv::Exception);
    EXPECT_THROW(buildPyramid(image, Mat(32, 31, CV_8UC1, Scalar(0)), 1), cv::Exception);
    EXPECT_THROW(buildPyramid(image, Mat(32, 32, CV_32FC1, Scalar(0)), 1), cv::Exception);
    EXPECT_THROW(buildPyramid(image, Mat(), 0), cv::Exception);
}

}} // namespace
