// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#include "evaluation/input_jitter.hpp"

#include <algorithm>
#include <cmath>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>

namespace evaluation
{

namespace
{

const int MIN_SIDE = 3; ///< px: a frame of one pixel and something in it

cv::Size times(cv::Size size, double scale)
{
    return cv::Size(std::max(cvRound(size.width * scale), 1), std::max(cvRound(size.height * scale), 1));
}

cv::Mat scaledTo(const cv::Mat& image, cv::Size size)
{
    if (size == image.size())
        return image;
    cv::Mat scaled;
    cv::resize(image, scaled, size, 0, 0, cv::INTER_AREA);
    return scaled;
}

} // namespace

cv::Mat jitteredInput(const cv::Mat& photograph, double megapix, int input)
{
    CV_CheckTypeEQ(photograph.type(), CV_8UC3, "inputs are made of BGR photographs with 8 bits a channel");
    CV_CheckGT(megapix, 0.0, "photographs are scaled down to more than 0 million pixels");
    CV_Check(input, input >= 1 && input <= INPUTS, "a photograph is brought to the inputs 1 to 5");
    CV_CheckGE(std::min(photograph.cols, photograph.rows), MIN_SIDE, "a photograph needs 3 x 3 px or more");
    const double scale = std::min(1.0, std::sqrt(megapix * 1e6 / static_cast<double>(photograph.total())));
    const cv::Size given = times(photograph.size(), scale);
    CV_CheckGE(std::min(given.width, given.height), MIN_SIDE, "megapix must leave 3 x 3 px or more");
    switch (input)
    {
    case 2:
        return scaledTo(photograph, given)(cv::Rect(1, 1, given.width - 2, given.height - 2));
    case 3:
        return scaledTo(photograph, cv::Size(given.width + 1, given.height));
    case 4:
        return scaledTo(photograph, times(photograph.size(), scale * std::sqrt(47.0 / 48)));
    case 5:
        return scaledTo(photograph, times(photograph.size(), scale * std::sqrt(46.0 / 48)));
    default:
        return scaledTo(photograph, given);
    }
}

cv::Mat readInput(const std::string& path, double megapix, int input)
{
    const cv::Mat photograph = cv::imread(path, cv::IMREAD_COLOR);
    if (photograph.empty())
        CV_Error(cv::Error::StsObjectNotFound, path + " is not an image that OpenCV can read");
    return jitteredInput(photograph, megapix, input);
}

} // namespace evaluation
