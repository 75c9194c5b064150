// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#ifndef GCPW_APPS_REPORT_WARPED_PHOTOGRAPHS_HPP
#define GCPW_APPS_REPORT_WARPED_PHOTOGRAPHS_HPP

#include <vector>
#include <opencv2/stitching/detail/camera.hpp>
#include <opencv2/stitching/detail/exposure_compensate.hpp>
#include <opencv2/stitching/warpers.hpp>
#include "evaluation/warped_image.hpp"

namespace report
{

/// Photographs and their cameras.
struct Cameras
{
    std::vector<cv::Mat> photographs; ///< CV_8UC3 or CV_8UC4, whose alpha is the mask of what is to be shown
    std::vector<int> component;       ///< which of them have a camera
    std::vector<cv::detail::CameraParams> cameras; ///< of these
    double focal = 0;                              ///< that cv::Stitcher scales its picture by
    double work_scale = 1;                         ///< pixels that the cameras refer to, per pixel of the photographs
};

/// Scale of the warper that shows photographs at `scale` pixels for one of theirs.
double warperScale(const Cameras& cameras, double scale);

/** @brief Photographs warped at any scale.
@param scale pixels shown per pixel of the photographs, > 0
@return those with a camera, in that order */
std::vector<evaluation::WarpedImage> warpedPhotographs(const Cameras& cameras, cv::WarperCreator& warper,
                                                       cv::detail::ExposureCompensator& compensator, double scale);

} // namespace report

#endif
