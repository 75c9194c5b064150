// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#ifndef GCPW_APPS_SYNTHETIC_PAIR_HPP
#define GCPW_APPS_SYNTHETIC_PAIR_HPP

#include <opencv2/core.hpp>

/** @brief Two overlapping pictures, 800 x 600 px, CV_8UC3, of a painted scene with parallax and different exposure.

Always the same pictures: for trying the programs where no photographs are at hand. */
void makeSyntheticPair(cv::Mat& source, cv::Mat& target);

#endif
