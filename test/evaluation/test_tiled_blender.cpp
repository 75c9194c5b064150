// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#include <gtest/gtest.h>
#include <opencv2/imgproc.hpp>
#include "common/tiled_blender.hpp"
#include "fed.hpp"

namespace
{

/// A picture with detail of all sizes.
cv::Mat picture(cv::Size size, int seed)
{
    cv::Mat sum(size, CV_32FC3, cv::Scalar::all(0));
    cv::RNG rng(static_cast<uint64_t>(seed));
    for (const int side : {4, 32, 256})
    {
        cv::Mat noise(size.height / side + 2, size.width / side + 2, CV_32FC3);
        rng.fill(noise, cv::RNG::UNIFORM, 0, 80);
        cv::resize(noise, noise, size, 0, 0, cv::INTER_CUBIC);
        sum += noise;
    }
    cv::Mat result;
    sum.convertTo(result, CV_16S);
    return cv::min(cv::max(result, 0), 255);
}

/// Three pictures side by side, each with a mask that ends in the next.
std::vector<Fed> threePictures()
{
    std::vector<Fed> fed;
    for (int k = 0; k < 3; ++k)
    {
        Fed one;
        one.image = picture(cv::Size(1400, 1500 - 100 * k), k + 1);
        one.mask = cv::Mat(one.image.size(), CV_8UC1, cv::Scalar(0));
        cv::circle(one.mask, cv::Point(700, 700), 640, cv::Scalar(255), cv::FILLED);
        one.corner = cv::Point(-300 + 850 * k, 70 * k - 40);
        fed.push_back(one);
    }
    return fed;
}

void blendWith(cv::detail::Blender& blender, cv::Mat& blended, cv::Mat& mask)
{
    const std::vector<Fed> fed = threePictures();
    blender.prepare(canvasOf(fed));
    for (const Fed& one : fed)
        blender.feed(one.image, one.mask, one.corner);
    blender.blend(blended, mask);
    blended.convertTo(blended, CV_8U);
}

TEST(TiledBlender, its_picture_is_that_of_one_piece)
{
    cv::Mat whole;
    cv::Mat whole_mask;
    cv::detail::MultiBandBlender one_piece(0, 5);
    blendWith(one_piece, whole, whole_mask);
    cv::Mat tiled;
    cv::Mat tiled_mask;
    TiledBlender tiles;
    blendWith(tiles, tiled, tiled_mask);
    ASSERT_EQ(tiled.size(), whole.size());
    ASSERT_GT(whole.cols, 2048) << "several tiles are needed";
    EXPECT_LE(cv::norm(tiled, whole, cv::NORM_INF), 1);
    EXPECT_EQ(cv::norm(tiled_mask, whole_mask, cv::NORM_INF), 0);
}

TEST(TiledBlender, sixteen_bits_are_blended_as_eight_are)
{
    std::vector<Fed> fed = threePictures();
    TiledBlender plain;
    plain.prepare(canvasOf(fed));
    TiledBlender deep(TiledBlender::USUAL_BANDS, true);
    deep.prepare(canvasOf(fed));
    for (const Fed& one : fed)
    {
        plain.feed(one.image, one.mask, one.corner);
        cv::Mat scaled;
        one.image.convertTo(scaled, CV_16S, 32);
        deep.feed(scaled, one.mask, one.corner);
    }
    cv::Mat blended[2];
    cv::Mat masks[2];
    plain.blend(blended[0], masks[0]);
    deep.blend(blended[1], masks[1]);
    ASSERT_EQ(blended[1].type(), CV_16SC3);
    EXPECT_EQ(cv::norm(masks[0], masks[1], cv::NORM_INF), 0);
    blended[0].convertTo(blended[0], CV_32F);
    blended[1].convertTo(blended[1], CV_32F, 1.0 / 32);
    // OpenCV cuts off what is behind the point, in every band: 8 bits come out darker and noisier.
    EXPECT_LE(cv::norm(blended[0], blended[1], cv::NORM_L1) / (3.0 * static_cast<double>(blended[0].total())), 3);
}

TEST(TiledBlender, an_image_that_does_not_show_changes_nothing)
{
    TiledBlender blender;
    blender.prepare(cv::Rect(0, 0, 300, 200));
    blender.feed(picture(cv::Size(300, 200), 1), cv::Mat(200, 300, CV_8UC1, cv::Scalar(0)), cv::Point());
    cv::Mat blended;
    cv::Mat mask;
    blender.blend(blended, mask);
    EXPECT_EQ(blended.size(), cv::Size(300, 200));
    EXPECT_EQ(cv::countNonZero(mask), 0);
}

} // namespace
