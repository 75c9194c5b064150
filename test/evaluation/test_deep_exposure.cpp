// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#include <gtest/gtest.h>
#include <opencv2/imgproc.hpp>
#include "common/deep_exposure.hpp"

namespace
{

typedef cv::detail::ExposureCompensator Compensator;

/// Smooth, and away from both ends, where 8 bits are clipped.
cv::Mat picture(const cv::Scalar& light)
{
    cv::Mat noise(12, 16, CV_8UC3);
    cv::RNG(4).fill(noise, cv::RNG::UNIFORM, 60, 120);
    cv::resize(noise, noise, cv::Size(160, 120), 0, 0, cv::INTER_LINEAR);
    cv::Mat lit;
    cv::multiply(noise, light, lit);
    return lit;
}

TEST(DeepExposure, sixteen_bits_are_corrected_as_eight_are)
{
    const std::vector<cv::Mat> images = {picture(cv::Scalar(1, 1, 1)), picture(cv::Scalar(1.4, 1.2, 1.1))};
    const std::vector<cv::Point> corners = {{0, 0}, {40, 10}};
    const cv::Mat mask(images[0].size(), CV_8UC1, cv::Scalar(255));
    const std::vector<cv::UMat> fed = {images[0].getUMat(cv::ACCESS_READ), images[1].getUMat(cv::ACCESS_READ)};
    const std::vector<cv::UMat> masks(2, mask.getUMat(cv::ACCESS_READ));
    for (const int type : {Compensator::NO, Compensator::GAIN, Compensator::GAIN_BLOCKS, Compensator::CHANNELS,
                           Compensator::CHANNELS_BLOCKS})
    {
        const cv::Ptr<Compensator> compensator = Compensator::createDefault(type);
        compensator->feed(corners, fed, masks);
        for (int k = 0; k < 2; ++k)
        {
            cv::Mat bytes = images[static_cast<size_t>(k)].clone();
            cv::Mat deep;
            bytes.convertTo(deep, CV_16U, 257);
            correctExposure(*compensator, k, corners[static_cast<size_t>(k)], bytes, mask);
            correctExposure(*compensator, k, corners[static_cast<size_t>(k)], deep, mask);
            cv::Mat back;
            deep.convertTo(back, CV_8U, 1.0 / 257);
            EXPECT_LE(cv::norm(back, bytes, cv::NORM_INF), 1) << type;
            EXPECT_EQ(cv::norm(bytes, images[static_cast<size_t>(k)], cv::NORM_INF) < 3, type == Compensator::NO)
                << type << " " << k;
        }
    }
}

} // namespace
