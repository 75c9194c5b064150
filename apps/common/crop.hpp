// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#ifndef GCPW_APPS_CROP_HPP
#define GCPW_APPS_CROP_HPP

#include <opencv2/core.hpp>

/** @brief The largest upright rectangle, by area, that holds pixels of a picture only.
@param shown CV_8UC1, not 0 where the picture has pixels
@return the topmost, then leftmost of equal ones; empty if nothing is shown */
cv::Rect largestRectangle(const cv::Mat& shown);

#endif
