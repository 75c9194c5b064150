// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#include <cmath>
#include <gtest/gtest.h>
#include <opencv2/imgproc.hpp>
#include "evaluation/locality_sensitive_histogram.hpp"

namespace
{

using evaluation::invariantImage;
using evaluation::LshOptions;

/// Smooth blobs, gray 60 to 250.
cv::Mat blobs(cv::Size size)
{
    cv::RNG random(7);
    cv::Mat image(size, CV_32F);
    random.fill(image, cv::RNG::UNIFORM, 0, 1);
    cv::GaussianBlur(image, image, cv::Size(), 2.5);
    cv::normalize(image, image, 60, 250, cv::NORM_MINMAX);
    image.convertTo(image, CV_8U);
    return image;
}

/// The formula, pixel by pixel.
double byDefinition(const cv::Mat& gray, cv::Point p, const LshOptions& options)
{
    const double alpha = std::exp(-1 / (options.reach * std::hypot(gray.cols, gray.rows)));
    const auto place = [&](cv::Point q) { return gray.at<uchar>(q) * (options.bins - 1) / 255.0; };
    const double width = std::max(options.narrowest, options.relative * place(p));
    double sum = 0;
    double weights = 0;
    for (int y = 0; y < gray.rows; ++y)
        for (int x = 0; x < gray.cols; ++x)
        {
            const double weight = std::pow(alpha, std::abs(x - p.x) + std::abs(y - p.y));
            weights += weight;
            for (int b = 0; b < options.bins; ++b)
            {
                const double share = std::max(0.0, 1 - std::abs(place(cv::Point(x, y)) - b));
                const double d = b - place(p);
                sum += weight * share * std::exp(-d * d / (2 * width * width));
            }
        }
    return 255 * sum / weights;
}

TEST(Evaluation_Lsh, recursive_passes_give_the_formula)
{
    const cv::Mat gray = blobs(cv::Size(41, 30));
    LshOptions options;
    options.bins = 19; // no multiple of what is filtered at a time
    const cv::Mat feature = invariantImage(gray, options);
    ASSERT_EQ(feature.type(), CV_8UC3);
    for (const cv::Point p : {cv::Point(0, 0), cv::Point(40, 29), cv::Point(20, 11), cv::Point(3, 28)})
        EXPECT_NEAR(feature.at<cv::Vec3b>(p)[1], byDefinition(gray, p, options), 0.51) << p;
}

TEST(Evaluation_Lsh, a_gain_that_varies_over_the_image_hardly_changes_the_feature)
{
    const cv::Mat gray = blobs(cv::Size(320, 240));
    cv::Mat dimmed(gray.size(), CV_8U);
    for (int y = 0; y < gray.rows; ++y)
        for (int x = 0; x < gray.cols; ++x)
            dimmed.at<uchar>(y, x) = cv::saturate_cast<uchar>(gray.at<uchar>(y, x) * (0.9 - 0.4 * x / gray.cols));
    const auto spread = [](const cv::Mat& image)
    {
        cv::Scalar mean;
        cv::Scalar deviation;
        cv::meanStdDev(image, mean, deviation);
        return deviation[0];
    };
    const auto difference = [](const cv::Mat& a, const cv::Mat& b)
    { return cv::norm(a, b, cv::NORM_L1) / static_cast<double>(a.total() * a.channels()); };
    const cv::Mat feature = invariantImage(gray);
    const double of_pixels = difference(gray, dimmed) / spread(gray);
    const double of_features = difference(feature, invariantImage(dimmed)) / spread(feature);
    EXPECT_GT(of_pixels, 1.0);
    EXPECT_LT(of_features, 0.2);
}

TEST(Evaluation_Lsh, a_flat_image_is_all_alike_with_itself)
{
    const cv::Mat flat(30, 40, CV_8UC3, cv::Scalar::all(255));
    const cv::Mat feature = invariantImage(flat);
    EXPECT_EQ(cv::norm(feature, cv::Mat(feature.size(), CV_8UC3, cv::Scalar::all(255)), cv::NORM_INF), 0);
}

TEST(Evaluation_Lsh, wrong_input_is_refused)
{
    EXPECT_THROW(invariantImage(cv::Mat()), cv::Exception);
    EXPECT_THROW(invariantImage(cv::Mat(4, 4, CV_32F, cv::Scalar(0))), cv::Exception);
    LshOptions options;
    options.bins = 1;
    EXPECT_THROW(invariantImage(blobs(cv::Size(20, 20)), options), cv::Exception);
}

} // namespace
