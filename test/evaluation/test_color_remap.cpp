// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <opencv2/imgproc.hpp>
#include "common/synthetic_pair.hpp"
#include "evaluation/color_remap.hpp"
#include "evaluation/color_variation.hpp"

namespace
{

using evaluation::ColorCurves;
using evaluation::MonotoneSpline;

const double GRAY_LEVEL = 1.0 / 255;

/// Every colour, in any order.
cv::Mat noise(int seed)
{
    cv::RNG random(seed);
    cv::Mat image(240, 320, CV_8UC3);
    random.fill(image, cv::RNG::UNIFORM, 0, 256);
    return image;
}

double gammaCurve(double x)
{
    return 0.05 + 0.85 * std::pow(x, 1.4);
}

TEST(Evaluation_MonotoneSpline, a_known_curve_is_recovered_within_a_gray_level)
{
    std::vector<double> x;
    std::vector<double> y;
    for (int i = 0; i <= 100; ++i)
    {
        x.push_back(i / 100.0);
        y.push_back(gammaCurve(x.back()));
    }
    const MonotoneSpline spline = MonotoneSpline::fit(x, y);
    for (double t = 0; t <= 1; t += 0.01)
        EXPECT_NEAR(spline.at(t), gammaCurve(t), GRAY_LEVEL) << t;
}

TEST(Evaluation_MonotoneSpline, slopes_stay_within_their_bounds_whatever_the_data)
{
    evaluation::SplineOptions options;
    const MonotoneSpline falling = MonotoneSpline::fit({0, 0.5, 1}, {1, 0.5, 0}, options);
    const MonotoneSpline jump = MonotoneSpline::fit({0, 0.49, 0.51, 1}, {0, 0, 1, 1}, options);
    for (const MonotoneSpline& spline : {falling, jump})
        for (double slope : spline.slopes())
        {
            EXPECT_GE(slope, options.min_slope);
            EXPECT_LE(slope, options.max_slope);
        }
}

TEST(Evaluation_MonotoneSpline, without_data_it_is_the_identity)
{
    const MonotoneSpline none = MonotoneSpline::fit({}, {});
    const MonotoneSpline dark = MonotoneSpline::fit({0.1, 0.15, 0.2}, {0.1, 0.15, 0.2});
    for (double t = 0; t <= 1; t += 0.1)
    {
        EXPECT_NEAR(none.at(t), t, 1e-12);
        EXPECT_NEAR(dark.at(t), t, 1e-9);
    }
}

TEST(Evaluation_MonotoneSpline, wrong_options_are_refused)
{
    evaluation::SplineOptions options;
    options.min_slope = 0;
    EXPECT_THROW(MonotoneSpline::fit({0.5}, {0.5}, options), cv::Exception);
    EXPECT_THROW(MonotoneSpline::fit({0.5}, {}), cv::Exception);
}

TEST(Evaluation_ColorRemap, curves_between_shuffled_copies_are_recovered_within_a_gray_level)
{
    const cv::Mat from = noise(1);
    cv::Mat to = noise(2); // the same colours elsewhere
    for (int y = 0; y < to.rows; ++y)
        for (int x = 0; x < to.cols; ++x)
            for (int c = 0; c < 3; ++c)
            {
                uchar& value = to.at<cv::Vec3b>(y, x)[c];
                value = cv::saturate_cast<uchar>(255 * gammaCurve(value / 255.0));
            }
    const cv::Mat all(from.size(), CV_8UC1, cv::Scalar(255));
    const ColorCurves curves = evaluation::fitColorCurves(from, all, to, all);
    for (int c = 0; c < 3; ++c)
        for (double t = 0.02; t <= 0.98; t += 0.01)
            EXPECT_NEAR(curves[c].at(t), gammaCurve(t), 1.5 * GRAY_LEVEL) << c << ' ' << t;
}

TEST(Evaluation_ColorRemap, only_masked_pixels_count)
{
    const cv::Mat from = noise(1);
    cv::Mat to = from * 0.7;
    cv::Mat mask(from.size(), CV_8UC1, cv::Scalar(255));
    const cv::Rect spoiled(0, 0, from.cols / 2, from.rows);
    to(spoiled).setTo(cv::Scalar::all(255));
    mask(spoiled).setTo(0);
    const ColorCurves curves = evaluation::fitColorCurves(from, mask, to, mask);
    EXPECT_NEAR(curves[1].at(0.6), 0.42, 2 * GRAY_LEVEL);
    const cv::Mat none = cv::Mat::zeros(from.size(), CV_8UC1);
    EXPECT_DOUBLE_EQ(evaluation::fitColorCurves(from, none, to, none)[1].at(0.6), 0.6);
}

TEST(Evaluation_ColorRemap, identity_curves_leave_the_image_alone)
{
    const cv::Mat image = noise(1);
    EXPECT_EQ(cv::norm(evaluation::applyColorCurves(image, ColorCurves()), image, cv::NORM_INF), 0);
}

TEST(Evaluation_ColorVariation, degree_0_is_the_image_itself)
{
    const cv::Mat image = noise(1);
    EXPECT_EQ(cv::norm(evaluation::varyColors(image, 0), image, cv::NORM_INF), 0);
}

TEST(Evaluation_ColorVariation, colours_differ_more_with_every_degree)
{
    cv::Mat image;
    cv::Mat target;
    makeSyntheticPair(image, target);
    double before = 0;
    for (int degree = 1; degree <= evaluation::MAX_DEGREE; ++degree)
    {
        const double difference = cv::norm(evaluation::varyColors(image, degree), image, cv::NORM_L1);
        EXPECT_GT(difference, before) << degree;
        before = difference;
    }
}

TEST(Evaluation_ColorVariation, no_other_degree_and_type_is_taken)
{
    EXPECT_THROW(evaluation::varyColors(noise(1), -1), cv::Exception);
    EXPECT_THROW(evaluation::varyColors(noise(1), 17), cv::Exception);
    EXPECT_THROW(evaluation::varyColors(cv::Mat(4, 4, CV_8UC1, cv::Scalar(0)), 3), cv::Exception);
}

} // namespace
