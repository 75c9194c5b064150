// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#ifndef OPENCV_GCPW_PYRAMID_HPP
#define OPENCV_GCPW_PYRAMID_HPP

#include <vector>
#include <opencv2/core.hpp>

namespace cv
{
namespace gcpw
{

/** @brief One level of an image: Y, Cr, Cb in [0, 1] and, as a fourth channel, 1 inside the mask and 0 outside.

The level is made with pyrDown, so pixel p of level l is pixel p * 2^l of the reference image. */
struct PyramidLevel
{
    Mat pixels;       ///< CV_32FC4
    double scale = 1; ///< reference pixels per pixel of this level, 2^l

    const float* at(int x, int y) const { return pixels.ptr<float>(y) + 4 * x; }
};

/** @brief Gaussian pyramid of an image, finest level first.
@param image CV_8UC3 BGR
@param mask CV_8UC1 of the same size, non-zero where the image has content; empty means everywhere
@param levels how many levels at most; a level smaller than 16 px on a side is not made
@return at least one level */
std::vector<PyramidLevel> buildPyramid(const Mat& image, const Mat& mask, int levels);

} // namespace gcpw
} // namespace cv

#endif
