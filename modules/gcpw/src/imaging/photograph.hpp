// Part of the GCPW module for OpenCV. Licence: Apache-2.0 (see LICENSE).
#ifndef OPENCV_GCPW_PHOTOGRAPH_HPP
#define OPENCV_GCPW_PHOTOGRAPH_HPP

#include <opencv2/core.hpp>

namespace cv
{
namespace gcpw
{

/// An input image in the one form the module works on.
struct Photograph
{
    Mat image; ///< CV_8UC3 BGR, full resolution; mid-gray where it is not valid
    Mat mask;  ///< CV_8UC1, 255 where valid; empty means everywhere
};

/** @brief Converts what a caller may pass: 8- or 16-bit, gray, BGR or BGRA (alpha > half is valid).
@param name for messages ("source", "target")
@throws cv::Exception if the image is empty or of another type */
Photograph toPhotograph(InputArray input, const char* name);

/** @brief Narrows a photograph to the pixels where `valid` (CV_8UC1 of its size) is non-zero.

What lies outside is replaced by the nearest valid pixel: filters look over the border of a mask, and there must be
neither what was hidden nor an edge. The image is copied first if anything is hidden. */
void hideOutside(Photograph& photograph, const Mat& valid);

/// Size of an image scaled down to at most `megapix` million pixels; never scaled up, at least 1 x 1.
Size cappedSize(Size full, double megapix);

/// The photograph at another size (area average when shrinking).
Photograph resized(const Photograph& photograph, Size size);

} // namespace gcpw
} // namespace cv

#endif
