// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#include "test_precomp.hpp"

#include "rendering/extension.hpp"
#include "scene.hpp"

namespace opencv_test { namespace {

using cv::gcpw::extendOutside;

Mat discMask(Size size)
{
    Mat mask = Mat::zeros(size, CV_8UC1);
    for (int y = 0; y < size.height; ++y)
        for (int x = 0; x < size.width; ++x)
            if (std::hypot(x - 0.4 * size.width, y - 0.5 * size.height) < 0.3 * size.height)
                mask.at<uchar>(y, x) = 255;
    return mask;
}

TEST(Gcpw_Extension, the_inside_stays_as_it_is_and_the_outside_keeps_its_range)
{
    const Mat mask = discMask(Size(157, 93));
    const Texture texture(3);
    Mat image(mask.size(), CV_8UC3);
    for (int y = 0; y < image.rows; ++y)
        for (int x = 0; x < image.cols; ++x)
            image.at<Vec3b>(y, x) = mask.at<uchar>(y, x) ? Vec3b(texture.at(Point2d(x, y)) * 255.0) : Vec3b();
    const Mat before = image.clone();
    // The texture lies in [0.25, 0.6].
    extendOutside(image, mask);
    EXPECT_EQ(cv::norm(image, before, NORM_INF, mask), 0);
    for (int y = 0; y < image.rows; ++y)
        for (int x = 0; x < image.cols; ++x)
            for (int c = 0; c < 3; ++c)
            {
                ASSERT_GE(image.at<Vec3b>(y, x)[c], 0.25 * 255 - 1);
                ASSERT_LE(image.at<Vec3b>(y, x)[c], 0.6 * 255 + 1);
            }
}

TEST(Gcpw_Extension, one_colour_goes_on_as_that_colour_in_every_depth)
{
    const Mat mask = discMask(Size(64, 65));
    for (const int type : {CV_8UC3, CV_16SC3, CV_8UC1, CV_32FC1})
    {
        Mat image = Mat::zeros(mask.size(), type);
        image.setTo(Scalar(90, 120, 150), mask);
        extendOutside(image, mask);
        EXPECT_LE(cv::norm(image, Mat(mask.size(), type, Scalar(90, 120, 150)), NORM_INF), 1e-3) << type;
    }
}

TEST(Gcpw_Extension, there_is_no_step_at_the_border)
{
    Mat mask = Mat::zeros(Size(200, 100), CV_8UC1);
    mask.colRange(0, 100).setTo(255);
    Mat image = Mat::zeros(mask.size(), CV_32FC1);
    for (int y = 0; y < image.rows; ++y)
        for (int x = 0; x < 100; ++x)
            image.at<float>(y, x) = static_cast<float>(x + y);
    extendOutside(image, mask);
    for (int y = 0; y < image.rows; ++y)
        EXPECT_NEAR(image.at<float>(y, 99), image.at<float>(y, 100), 8) << y;
}

TEST(Gcpw_Extension, with_nothing_inside_nothing_is_written)
{
    Mat image(20, 30, CV_8UC3, Scalar(1, 2, 3));
    extendOutside(image, Mat::zeros(image.size(), CV_8UC1));
    EXPECT_EQ(cv::norm(image, Mat(image.size(), CV_8UC3, Scalar(1, 2, 3)), NORM_INF), 0);
}

}} // namespace
