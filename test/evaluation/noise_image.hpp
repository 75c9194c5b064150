// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#ifndef GCPW_TEST_EVALUATION_NOISE_IMAGE_HPP
#define GCPW_TEST_EVALUATION_NOISE_IMAGE_HPP

#include <opencv2/imgproc.hpp>

/// Soft blobs of every colour, CV_8UC3: each window looks like no other one.
inline cv::Mat noiseImage(cv::Size size, int seed)
{
    cv::Mat image(size, CV_8UC3);
    cv::RNG rng(static_cast<uint64_t>(seed));
    rng.fill(image, cv::RNG::UNIFORM, 0, 256);
    cv::GaussianBlur(image, image, cv::Size(), 2);
    cv::normalize(image, image, 0, 255, cv::NORM_MINMAX);
    return image;
}

#endif
