// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#include <cmath>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>
#include "evaluation/input_jitter.hpp"
#include "scratch_folder.hpp"

namespace
{

using evaluation::jitteredInput;

cv::Mat noise(int width, int height)
{
    cv::Mat image(height, width, CV_8UC3);
    cv::RNG(7).fill(image, cv::RNG::UNIFORM, 0, 256);
    return image;
}

bool same(const cv::Mat& a, const cv::Mat& b)
{
    return a.size() == b.size() && a.type() == b.type() && cv::norm(a, b, cv::NORM_INF) == 0;
}

TEST(Evaluation_InputJitter, sizes_differ_by_about_a_pixel_around_the_first)
{
    const cv::Mat photograph = noise(800, 600); // 0.48 million pixels
    const cv::Size expected[] = {{400, 300}, {398, 298}, {401, 300}, {396, 297}, {392, 294}};
    for (int input = 1; input <= evaluation::INPUTS; ++input)
    {
        const cv::Mat image = jitteredInput(photograph, 0.12, input);
        EXPECT_EQ(image.size(), expected[input - 1]) << input;
        EXPECT_EQ(image.type(), CV_8UC3);
    }
}

TEST(Evaluation_InputJitter, pixels_are_those_of_one_area_average_of_the_photograph)
{
    const cv::Mat photograph = noise(800, 600);
    const cv::Mat given = jitteredInput(photograph, 0.12, 1);
    EXPECT_TRUE(same(jitteredInput(photograph, 0.12, 2), given(cv::Rect(1, 1, 398, 298))));
    for (const int input : {1, 3, 4, 5})
    {
        const cv::Mat image = jitteredInput(photograph, 0.12, input);
        cv::Mat expected;
        cv::resize(photograph, expected, image.size(), 0, 0, cv::INTER_AREA);
        EXPECT_TRUE(same(image, expected)) << input;
    }
}

TEST(Evaluation_InputJitter, a_photograph_that_is_small_enough_is_given_as_it_is_and_still_jittered)
{
    const cv::Mat photograph = noise(200, 150);
    EXPECT_TRUE(same(jitteredInput(photograph, 1, 1), photograph));
    const cv::Size expected[] = {{200, 150}, {198, 148}, {201, 150}, {198, 148}, {196, 147}};
    for (int input = 1; input <= evaluation::INPUTS; ++input)
        EXPECT_EQ(jitteredInput(photograph, 1, input).size(), expected[input - 1]) << input;
}

TEST(Evaluation_InputJitter, what_has_no_inputs_is_refused)
{
    const cv::Mat photograph = noise(40, 30);
    for (const int input : {0, 6})
        EXPECT_THROW(jitteredInput(photograph, 1, input), cv::Exception) << input;
    for (const double megapix : {0.0, -1.0, std::nan(""), 1e-6})
        EXPECT_THROW(jitteredInput(photograph, megapix, 1), cv::Exception) << megapix;
    EXPECT_THROW(jitteredInput(noise(2, 30), 1, 2), cv::Exception);
    EXPECT_THROW(jitteredInput(cv::Mat(), 1, 1), cv::Exception);
    EXPECT_THROW(jitteredInput(cv::Mat(30, 40, CV_8UC1, cv::Scalar(0)), 1, 1), cv::Exception);
}

TEST(Evaluation_InputJitter, a_file_is_read_in_colour_and_named_if_it_cannot_be)
{
    const ScratchFolder folder;
    cv::imwrite(folder.path("a.png"), cv::Mat(300, 400, CV_8UC1, cv::Scalar(7)));
    EXPECT_EQ(evaluation::readInput(folder.path("a.png"), 1, 1).size(), cv::Size(400, 300));
    EXPECT_EQ(evaluation::readInput(folder.path("a.png"), 0.03, 1).size(), cv::Size(200, 150));
    EXPECT_EQ(evaluation::readInput(folder.path("a.png"), 1, 1).type(), CV_8UC3);
    try
    {
        evaluation::readInput(folder.path("b.png"), 1, 1);
        FAIL();
    }
    catch (const cv::Exception& error)
    {
        EXPECT_NE(error.err.find("b.png"), std::string::npos) << error.err;
    }
}

} // namespace
