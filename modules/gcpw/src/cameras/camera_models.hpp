// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#ifndef OPENCV_GCPW_CAMERA_MODELS_HPP
#define OPENCV_GCPW_CAMERA_MODELS_HPP

#include <vector>
#include <opencv2/stitching/detail/camera.hpp>
#include "cameras/linked_images.hpp"

namespace cv
{
namespace gcpw
{

/// What a set of photographs is taken for, in the order of trial.
enum class CameraModel
{
    TURNING,           ///< every camera turns and has a focal length of its own (OpenCV's estimator and ray adjuster)
    TURNING_NOTED,     ///< the same, adjusted from the focal lengths that the files note: LinkedImages::focals
    TURNING_ONE_FOCAL, ///< all have the same: fitTurningCameras()
    FLAT,              ///< photographs of a plane, seen straight on: fitSimilarities()
};

/** @brief Fits cameras to linked images.
@param images all linked with each other by `confidence`, directly or through others
@param cameras as cv::Stitcher keeps them: R is CV_32F, the world from the camera, or the image from the canvas if FLAT
@return false if there is no fit */
bool fitCameras(const LinkedImages& images, double confidence, CameraModel model,
                std::vector<cv::detail::CameraParams>& cameras);

} // namespace gcpw
} // namespace cv

#endif
