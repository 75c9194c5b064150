// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#include "evaluation/color_variation.hpp"

#include <cmath>

namespace evaluation
{

namespace
{

/// What the strongest degree does to one channel.
struct ChannelVariation
{
    double gain;      ///< G, geometric middle over the image
    double gamma;
    double bias;      ///< of the intensity range
    double direction; ///< t, radians: which way the gain varies
    double phase;     ///< f, radians
};

const ChannelVariation CHANNELS[3] = {{0.62, 0.85, 0.03, 0.4, 0.3}, {0.72, 1.15, -0.02, 1.3, 2.0}, {0.80, 1.3, 0.04, 2.4, 4.0}};
const double AMPLITUDE = 0.4; ///< A: gains vary by exp(+-A) over the image

} // namespace

cv::Mat varyColors(const cv::Mat& image, int degree)
{
    CV_CheckTypeEQ(image.type(), CV_8UC3, "colours are varied in 8-bit BGR");
    CV_Check(degree, degree >= 0 && degree <= MAX_DEGREE, "the degree of colour variation lies in 0..16");
    if (degree == 0)
        return image.clone();
    const double strength = static_cast<double>(degree) / MAX_DEGREE;
    double curve[3][256];
    for (int c = 0; c < 3; ++c)
        for (int i = 0; i < 256; ++i)
            curve[c][i] = 255 * std::pow(i / 255.0, std::pow(CHANNELS[c].gamma, strength));
    cv::Mat result(image.size(), CV_8UC3);
    for (int y = 0; y < image.rows; ++y)
        for (int x = 0; x < image.cols; ++x)
        {
            const double u = (x + 0.5) / image.cols;
            const double v = (y + 0.5) / image.rows;
            for (int c = 0; c < 3; ++c)
            {
                const ChannelVariation& variation = CHANNELS[c];
                const double wave = std::cos(CV_PI * (u * std::cos(variation.direction) + v * std::sin(variation.direction)) +
                                             variation.phase);
                const double gain = std::pow(variation.gain * std::exp(AMPLITUDE * wave), strength);
                result.at<cv::Vec3b>(y, x)[c] = cv::saturate_cast<uchar>(gain * curve[c][image.at<cv::Vec3b>(y, x)[c]] +
                                                                         255 * strength * variation.bias);
            }
        }
    return result;
}

} // namespace evaluation
