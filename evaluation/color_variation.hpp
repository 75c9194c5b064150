// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#ifndef GCPW_EVALUATION_COLOR_VARIATION_HPP
#define GCPW_EVALUATION_COLOR_VARIATION_HPP

#include <opencv2/core.hpp>

namespace evaluation
{

const int MAX_DEGREE = 16; ///< the strongest synthetic colour variation

/** @brief Recolours a photograph by degree: gain, bias and gamma for each channel, the gain varying over the image.

With s = degree / 16, intensities I in [0, 1] and u, v in [0, 1] across and down the image,
    I' = gain_c(u, v)^s * I^(gamma_c^s) + s * bias_c
    gain_c(u, v) = G_c * exp(A * cos(pi * (u * cos(t_c) + v * sin(t_c)) + f_c)),
clipped to [0, 1] and rounded to 8 bits. The constants G, gamma, bias, t, f of each channel and A stand in the source file:
gains from 0.4 to 1.2, gammas from 0.8 to 1.3, biases of a few gray levels.
@param image CV_8UC3 BGR
@param degree 0 (the image itself) to MAX_DEGREE
@throws cv::Exception if the image is of another type or the degree out of range */
cv::Mat varyColors(const cv::Mat& image, int degree);

} // namespace evaluation

#endif
