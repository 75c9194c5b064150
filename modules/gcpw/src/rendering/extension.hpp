// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#ifndef OPENCV_GCPW_EXTENSION_HPP
#define OPENCV_GCPW_EXTENSION_HPP

#include <opencv2/core.hpp>

namespace cv
{
namespace gcpw
{

/** @brief Fills what lies outside a mask smoothly with the colours next to it.

A multi-band blender mixes coarse bands of an image across its border: black out there would leave a dark or a bright seam.
Push and pull (Gortler et al., "The Lumigraph", 1996): averages of the inside, at ever coarser scales, fill the outside.
@param image any depth and channels; written outside the mask only
@param mask CV_8UC1 of the same size, non-zero inside; if nothing is inside, nothing is written */
void extendOutside(Mat& image, const Mat& mask);

} // namespace gcpw
} // namespace cv

#endif
