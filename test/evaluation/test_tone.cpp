// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#include <gtest/gtest.h>
#include <opencv2/imgproc.hpp>
#include "evaluation/tone.hpp"

namespace
{

using evaluation::Tone;
using evaluation::toneOf;
using evaluation::WarpedImage;

const cv::Size SIZE(320, 256); ///< 5 x 4 blocks

WarpedImage grayImage()
{
    WarpedImage image;
    image.place = cv::Rect(cv::Point(), SIZE);
    image.image = cv::Mat(SIZE, CV_8UC3, cv::Scalar::all(100));
    image.corrected = image.image.clone();
    image.mask = cv::Mat(SIZE, CV_8UC1, cv::Scalar(255));
    return image;
}

TEST(Evaluation_Tone, untouched_colours_are_perfect)
{
    for (const Tone& tone : {toneOf({grayImage()}), toneOf({})})
    {
        EXPECT_EQ(tone.largestCast(), 0);
        EXPECT_EQ(tone.local, 0);
        EXPECT_EQ(tone.crushed, 0);
        EXPECT_EQ(tone.blown, 0);
    }
}

TEST(Evaluation_Tone, light_is_a_cast_of_y_over_all_images_together)
{
    WarpedImage brighter = grayImage();
    brighter.corrected += cv::Scalar::all(10);
    EXPECT_NEAR(toneOf({brighter}).cast[0], 10, 1e-6);
    EXPECT_NEAR(toneOf({brighter, grayImage()}).cast[0], 5, 1e-6);
    WarpedImage darker = grayImage();
    darker.corrected -= cv::Scalar::all(10);
    EXPECT_NEAR(toneOf({brighter, darker}).largestCast(), 0, 1e-6);
    EXPECT_NEAR(toneOf({darker}).largestCast(), 10, 1e-6) << "without its sign";
}

TEST(Evaluation_Tone, a_tint_is_a_cast_of_cr_and_cb)
{
    WarpedImage image = grayImage();
    image.corrected += cv::Scalar(0, 0, 20); // red: Y = 0.299 R, Cr = 0.713 (R - Y), Cb = 0.564 (B - Y)
    const Tone tone = toneOf({image});
    EXPECT_NEAR(tone.cast[0], 0.299 * 20, 0.6);
    EXPECT_NEAR(tone.cast[1], 0.713 * (20 - 0.299 * 20), 0.6);
    EXPECT_NEAR(tone.cast[2], -0.564 * 0.299 * 20, 0.6);
    EXPECT_NEAR(tone.largestCast(), tone.cast[1], 1e-9);
    EXPECT_NEAR(tone.local, 0, 1e-3) << "everywhere the same";
}

TEST(Evaluation_Tone, a_tint_of_one_block_is_local)
{
    WarpedImage image = grayImage();
    image.corrected(cv::Rect(128, 64, 64, 64)) += cv::Scalar(0, 0, 20);
    EXPECT_NEAR(toneOf({image}).local, 0.713 * 14 * 19 / 20, 0.6);
    image.mask(cv::Rect(128, 64, 64, 64)).setTo(0);
    EXPECT_EQ(toneOf({image}).local, 0);
    EXPECT_EQ(toneOf({image}).largestCast(), 0);
}

TEST(Evaluation_Tone, crushed_and_blown_are_what_was_not_so_before)
{
    WarpedImage image = grayImage();
    const cv::Rect dark(0, 0, 32, 256), bright(32, 0, 64, 256), dark_before(96, 0, 32, 256), blue(128, 0, 32, 256);
    image.corrected(dark).setTo(cv::Scalar::all(23));
    image.corrected(bright).setTo(cv::Scalar::all(251));
    image.image(dark_before).setTo(cv::Scalar::all(10));
    image.corrected(dark_before).setTo(cv::Scalar::all(0));
    image.corrected(blue).setTo(cv::Scalar(60, 0, 0)); // one channel still tells things apart
    const Tone tone = toneOf({image});
    EXPECT_NEAR(tone.crushed, 10, 1e-9);
    EXPECT_NEAR(tone.blown, 20, 1e-9);
}

TEST(Evaluation_Tone, the_target_of_a_pair_does_not_thin_it_out)
{
    WarpedImage source = grayImage();
    source.corrected += cv::Scalar::all(10);
    WarpedImage target = grayImage();
    target.fixed = true;
    EXPECT_NEAR(toneOf({source, target}).cast[0], 10, 1e-6);
}

} // namespace
