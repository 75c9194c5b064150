// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#ifndef OPENCV_GCPW_SEAM_ROTATION_HPP
#define OPENCV_GCPW_SEAM_ROTATION_HPP

#include <opencv2/stitching/detail/warpers.hpp>

namespace cv
{
namespace gcpw
{

/// R after a rotation of the world about the vertical axis: canvas x of a cylinder grows by radians * scale.
Matx33f rotatedAboutAxis(const Matx33f& R, double radians);

/// Canvas pixels after which a warper's canvas repeats in x, or 0 if turning the camera does not just shift the picture.
double periodOf(cv::detail::RotationWarper& warper, Size image, const Mat& K, const Matx33f& R);

/** @brief The rotation about the vertical axis, in radians, that takes an image off the seam of a 360-degree canvas.
@return 0 for an image that does not straddle the seam; else an angle whose canvas shift is a whole number of pixels:
the image warped with rotatedAboutAxis(R, -angle) is contiguous, and angle * scale added to its x gives its own place */
double rotateOffSeam(cv::detail::RotationWarper& warper, Size image, const Mat& K, const Matx33f& R, double period);

} // namespace gcpw
} // namespace cv

#endif
