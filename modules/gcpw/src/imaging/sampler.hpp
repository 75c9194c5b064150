// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#ifndef OPENCV_GCPW_SAMPLER_HPP
#define OPENCV_GCPW_SAMPLER_HPP

#include "imaging/pyramid.hpp"

namespace cv
{
namespace gcpw
{

/// What an image shows at a point between its pixels: three channels and their gradient, per pixel of the reference image.
struct PixelSample
{
    float value[3];
    float dx[3];
    float dy[3];
};

/** @brief Bilinear value and bilinear central-difference gradient of a level.
@param level where to read
@param reference_px position in reference pixels
@param sample the result; set only if true is returned
@return false where the 4 x 4 neighbourhood leaves the image or any of the four nearest pixels leaves the mask

cv::remap would quantise the position to 1/32 px; here it keeps its full precision. */
bool samplePixel(const PyramidLevel& level, Point2d reference_px, PixelSample& sample);

/// The values alone; true at exactly the positions at which samplePixel() is.
bool sampleValue(const PyramidLevel& level, Point2d reference_px, PixelSample& sample);

/// The bilinear luma (first channel) alone. False where any of the four nearest pixels leaves the image or its mask.
bool sampleLuma(const PyramidLevel& level, Point2d reference_px, double& luma);

} // namespace gcpw
} // namespace cv

#endif
