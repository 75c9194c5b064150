// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#ifndef OPENCV_GCPW_PHOTOGRAPH_HPP
#define OPENCV_GCPW_PHOTOGRAPH_HPP

#include <opencv2/core.hpp>
#include "geometry/frame_scale.hpp"

namespace cv
{
namespace gcpw
{

/// An input image in the one form the module works on.
struct Photograph
{
    Mat image; ///< CV_8UC3 BGR, or CV_16UC3 to be rendered; the nearest valid pixel where it is not valid (see hideOutside())
    Mat mask;  ///< CV_8UC1, 255 where valid; empty means everywhere
};

/** @brief Refuses what toPhotograph() cannot convert.
@param name for messages ("source", "target")
@throws cv::Exception if the image is empty or of a type not listed there */
void checkPhotograph(const Mat& image, const char* name);

/// A picture of 8 or 16 bits with those of `depth`, CV_8U or CV_16U: 255 is 65535. The same pixels where it has them already.
Mat toDepth(const Mat& picture, int depth);

/** @brief Converts what a caller may pass: 8- or 16-bit, gray, BGR or BGRA (alpha > half is valid).
@param depth of the photograph, CV_8U or CV_16U
@throws cv::Exception as checkPhotograph() */
Photograph toPhotograph(InputArray input, const char* name, int depth = CV_8U);

/** @brief Narrows a photograph to the pixels where `valid` (CV_8UC1 of its size) is non-zero.

What lies outside is replaced by the nearest valid pixel: filters read across the border of a mask, and must find neither
the hidden content nor an edge there. The image is copied first if anything is hidden. */
void hideOutside(Photograph& photograph, const Mat& valid);

/// Size of an image scaled down to at most `megapix` million pixels; never scaled up, at least 1 x 1.
Size cappedSize(Size full, double megapix);

/** @brief The photograph scaled down (area average) to the nearest whole number of pixels a side, which must not be 0.

The scale itself, not that number, says where pixels lie. A pixel is valid if all it averages is.
@param scale pixels of the result per pixel of the photograph, at most 1; 1 copies nothing */
Photograph resized(const Photograph& photograph, const FrameScale& scale);

} // namespace gcpw
} // namespace cv

#endif
