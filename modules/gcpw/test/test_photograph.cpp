// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#include "test_precomp.hpp"

#include "imaging/photograph.hpp"
#include "seeded.hpp"

namespace opencv_test { namespace {

using namespace cv::gcpw;

Mat randomImage(Size size, int type)
{
    Mat image(size, type);
    seeded(1).fill(image, RNG::UNIFORM, 0, 256);
    return image;
}

TEST(Gcpw_Photograph, bgr_is_taken_as_it_is)
{
    const Mat image = randomImage(Size(20, 10), CV_8UC3);
    const Photograph photograph = toPhotograph(image, "source");
    EXPECT_EQ(cv::norm(photograph.image, image, NORM_INF), 0);
    EXPECT_TRUE(photograph.mask.empty());
}

TEST(Gcpw_Photograph, gray_becomes_three_equal_channels)
{
    const Mat image = randomImage(Size(20, 10), CV_8UC1);
    const Photograph photograph = toPhotograph(image, "source");
    ASSERT_EQ(photograph.image.type(), CV_8UC3);
    std::vector<Mat> planes;
    cv::split(photograph.image, planes);
    for (const Mat& plane : planes)
        EXPECT_EQ(cv::norm(plane, image, NORM_INF), 0);
}

TEST(Gcpw_Photograph, sixteen_bits_are_scaled_so_that_white_stays_white)
{
    const Mat eight = randomImage(Size(20, 10), CV_8UC3);
    Mat sixteen;
    eight.convertTo(sixteen, CV_16U, 257);
    EXPECT_EQ(cv::norm(toPhotograph(sixteen, "source").image, eight, NORM_INF), 0);
    const Mat white(4, 4, CV_16UC1, Scalar(65535));
    EXPECT_EQ(toPhotograph(white, "source").image.at<Vec3b>(0, 0), Vec3b(255, 255, 255));
}

TEST(Gcpw_Photograph, sixteen_bits_are_kept_where_they_are_asked_for)
{
    Mat deep(10, 20, CV_16UC3);
    seeded(3).fill(deep, RNG::UNIFORM, 0, 65536);
    EXPECT_EQ(cv::norm(toPhotograph(deep, "source", CV_16U).image, deep, NORM_INF), 0);
    const Mat eight = randomImage(Size(20, 10), CV_8UC3);
    const Mat raised = toPhotograph(eight, "source", CV_16U).image;
    ASSERT_EQ(raised.type(), CV_16UC3);
    EXPECT_EQ(cv::norm(toDepth(raised, CV_8U), eight, NORM_INF), 0);
    EXPECT_EQ(raised.at<Vec3w>(2, 3)[1], 257 * eight.at<Vec3b>(2, 3)[1]);
    Mat hidden(10, 20, CV_16UC4, Scalar(1000, 2000, 3000, 65535));
    hidden.at<Vec4w>(4, 4) = Vec4w(9, 9, 9, 0);
    const Photograph photograph = toPhotograph(hidden, "source", CV_16U);
    EXPECT_EQ(photograph.mask.at<uchar>(4, 4), 0);
    EXPECT_EQ(photograph.image.at<Vec3w>(4, 4), Vec3w(1000, 2000, 3000)) << "not that of a neighbour";
}

TEST(Gcpw_Photograph, alpha_above_half_is_valid)
{
    Mat image = randomImage(Size(20, 10), CV_8UC4);
    for (int y = 0; y < image.rows; ++y)
        for (int x = 0; x < image.cols; ++x)
            image.at<Vec4b>(y, x)[3] = x < 5 ? 127 : 128;
    const Photograph photograph = toPhotograph(image, "source");
    ASSERT_EQ(photograph.image.type(), CV_8UC3);
    ASSERT_EQ(photograph.mask.type(), CV_8UC1);
    for (int x = 0; x < image.cols; ++x)
        EXPECT_EQ(photograph.mask.at<uchar>(3, x), x < 5 ? 0 : 255);
    const Vec4b in = image.at<Vec4b>(4, 9);
    EXPECT_EQ(photograph.image.at<Vec3b>(4, 9), Vec3b(in[0], in[1], in[2]));
}

TEST(Gcpw_Photograph, what_alpha_hides_leaves_no_trace)
{
    Mat image = randomImage(Size(20, 10), CV_8UC4);
    image.at<Vec4b>(2, 2) = Vec4b(1, 2, 3, 0);
    const Photograph first = toPhotograph(image, "source");
    image.at<Vec4b>(2, 2) = Vec4b(200, 100, 0, 0);
    const Photograph second = toPhotograph(image, "source");
    EXPECT_EQ(cv::norm(first.image, second.image, NORM_INF), 0);
}

TEST(Gcpw_Photograph, full_alpha_is_no_mask)
{
    Mat image = randomImage(Size(20, 10), CV_8UC4);
    for (int i = 0; i < 200; ++i)
        image.at<Vec4b>(i / 20, i % 20)[3] = 255;
    EXPECT_TRUE(toPhotograph(image, "source").mask.empty());
}

TEST(Gcpw_Photograph, sixteen_bit_alpha_is_a_mask_too)
{
    Mat image(6, 6, CV_16UC4, Scalar(1000, 2000, 3000, 65535));
    image.at<Vec4w>(1, 1)[3] = 0;
    const Photograph photograph = toPhotograph(image, "source");
    ASSERT_FALSE(photograph.mask.empty());
    EXPECT_EQ(countNonZero(photograph.mask), 35);
}

TEST(Gcpw_Photograph, empty_or_foreign_images_are_refused_by_name)
{
    const int sizes[] = {4, 4, 4};
    for (const Mat& bad : {Mat(), Mat(4, 4, CV_32FC3, Scalar::all(0)), Mat(4, 4, CV_8UC2, Scalar::all(0)),
                           Mat(4, 4, CV_8SC3, Scalar::all(0)), Mat(3, sizes, CV_8UC1, Scalar::all(0))})
    {
        try
        {
            toPhotograph(bad, "left");
            FAIL() << "accepted " << typeToString(bad.type());
        }
        catch (const cv::Exception& error)
        {
            EXPECT_NE(std::string(error.what()).find("left"), std::string::npos) << error.what();
        }
    }
}

TEST(Gcpw_Photograph, the_capped_size_keeps_the_shape_and_never_grows)
{
    EXPECT_EQ(cappedSize(Size(640, 480), 1), Size(640, 480));
    EXPECT_EQ(cappedSize(Size(4000, 1000), 1), Size(2000, 500));
    EXPECT_EQ(cappedSize(Size(1000000, 1), 1e-6), Size(1000, 1));
    EXPECT_LE(cappedSize(Size(4321, 1234), 0.6).area(), 602000);
}

TEST(Gcpw_Photograph, resizing_keeps_pixel_squares_in_place_and_shrinks_the_mask_inwards)
{
    Photograph photograph;
    photograph.image = Mat(40, 60, CV_8UC3, Scalar::all(0));
    photograph.image(Rect(30, 0, 30, 40)).setTo(Scalar::all(200));
    photograph.mask = Mat(40, 60, CV_8UC1, Scalar(255));
    photograph.mask(Rect(0, 0, 9, 40)).setTo(0);
    const Photograph half = resized(photograph, FrameScale(Size(30, 20), photograph.image.size()));
    EXPECT_EQ(half.image.at<Vec3b>(5, 14), Vec3b(0, 0, 0));
    EXPECT_EQ(half.image.at<Vec3b>(5, 15), Vec3b(200, 200, 200));
    EXPECT_EQ(half.mask.at<uchar>(5, 4), 0) << "half of it is outside";
    EXPECT_EQ(half.mask.at<uchar>(5, 5), 255);
    EXPECT_EQ(resized(photograph, FrameScale()).image.data, photograph.image.data) << "copied for nothing";
}

TEST(Gcpw_Photograph, the_area_of_a_gigapixel_photograph_is_no_int)
{
    EXPECT_EQ(cappedSize(Size(60000, 60000), 1), Size(1000, 1000));
    EXPECT_EQ(cappedSize(Size(70000, 70000), 100), Size(10000, 10000));
}

}} // namespace
