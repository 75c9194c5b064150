// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#ifndef GCPW_EVALUATION_CUT_HPP
#define GCPW_EVALUATION_CUT_HPP

#include "evaluation/warped_image.hpp"

namespace evaluation
{

/// Which image each canvas pixel shows.
struct Labels
{
    cv::Point origin; ///< canvas pixel of the top-left label
    cv::Mat of;       ///< CV_16SC1, -1 where there is none
};

const double CUT_PIXELS = 0.3e6; ///< of the largest image, while the cut of a measurement is found

/** @brief Cuts a picture by OpenCV's graph cut (COST_COLOR_GRAD), in the colours that are shown.
@param images one or more
@param pixels of the largest image while the cut is found: images that have more are scaled down, more than 0 */
Labels graphCut(const std::vector<WarpedImage>& images, double pixels = CUT_PIXELS);

/** @brief Pixels whose right or lower neighbour shows the other one of two images.
@param labels CV_16SC1  @param valid CV_8UC1 of their size, 0 where pixels do not count  @param i, j the two images */
std::vector<cv::Point> cutPixels(const cv::Mat& labels, const cv::Mat& valid, int i, int j);

} // namespace evaluation

#endif
