// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#ifndef OPENCV_GCPW_BLEND_HPP
#define OPENCV_GCPW_BLEND_HPP

#include <array>
#include <opencv2/core.hpp>

namespace cv
{
namespace gcpw
{

/// Two pictures of one canvas: CV_8UC3 or CV_16UC3, both alike, black outside their masks.
typedef std::array<Mat, 2> TwoImages;

/// Where each has pixels: CV_8UC1, 255 inside.
typedef std::array<Mat, 2> TwoMasks;

/// The mean of both where both have pixels, and each alone elsewhere; of their type.
Mat blendAverage(const TwoImages& images, const TwoMasks& masks);

/// Graph-cut seam and multi-band blender of cv::Stitcher; black where neither has pixels. Of their type; of 16 bits the blender keeps 13.
Mat blendMultiband(const TwoImages& images, const TwoMasks& masks);

} // namespace gcpw
} // namespace cv

#endif
