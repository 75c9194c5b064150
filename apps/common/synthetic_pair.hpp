// Part of the GCPW module for OpenCV. Licence: Apache-2.0 (see LICENSE).
#ifndef GCPW_APPS_SYNTHETIC_PAIR_HPP
#define GCPW_APPS_SYNTHETIC_PAIR_HPP

#include <opencv2/core.hpp>

/** @brief Two overlapping pictures, 800 x 600 px, CV_8UC3, of a painted scene with parallax and different exposure.

Always the same pictures: for trying the programs where no photographs are at hand. */
void makeSyntheticPair(cv::Mat& source, cv::Mat& target);

#endif
