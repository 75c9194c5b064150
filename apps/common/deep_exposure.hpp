// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#ifndef GCPW_APPS_DEEP_EXPOSURE_HPP
#define GCPW_APPS_DEEP_EXPOSURE_HPP

#include <opencv2/stitching/detail/exposure_compensate.hpp>

/** @brief cv::detail::ExposureCompensator::apply() for 16 bits as well, which most of OpenCV's do not take.
@param index, corner, mask as there  @param image CV_8UC3 or CV_16UC3, corrected in place */
void correctExposure(cv::detail::ExposureCompensator& compensator, int index, cv::Point corner, cv::Mat& image,
                     const cv::Mat& mask);

#endif
