// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#ifndef GCPW_PYTHON_CAMERA_HPP
#define GCPW_PYTHON_CAMERA_HPP

#include <opencv2/stitching/detail/camera.hpp>
#include <pybind11/pybind11.h>
#include <vector>

/** @brief Cameras as Python has them.
@param cameras a sequence of gcpw.Camera, or of anything with its attributes, as cv2.detail.CameraParams
@throws pybind11::type_error that names the camera and what it lacks */
std::vector<cv::detail::CameraParams> camerasOf(const pybind11::sequence& cameras);

#endif
