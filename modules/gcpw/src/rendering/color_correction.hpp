// Part of the GCPW module for OpenCV. Licence: Apache-2.0 (see LICENSE).
#ifndef OPENCV_GCPW_COLOR_CORRECTION_HPP
#define OPENCV_GCPW_COLOR_CORRECTION_HPP

#include <opencv2/core.hpp>

namespace cv
{
namespace gcpw
{

/** @brief Applies a colour grid to an image, smoothly: bilinear between quad centres, so that no block shows.
@param bgr CV_8UC3
@param position CV_32FC2 of its size: where each pixel lies in the reference frame, full-resolution pixels
@param mask CV_8UC1 of its size: pixels outside stay as they are
@param color rows x cols, CV_32FC(6), as in Alignment::Image
@param reference_size full-resolution size of the reference frame
@return CV_8UC3 */
Mat correctColors(const Mat& bgr, const Mat& position, const Mat& mask, const Mat& color, Size reference_size);

} // namespace gcpw
} // namespace cv

#endif
