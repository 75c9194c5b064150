// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#ifndef OPENCV_GCPW_WARPED_LINES_HPP
#define OPENCV_GCPW_WARPED_LINES_HPP

#include <opencv2/stitching/detail/warpers.hpp>
#include "opencv2/gcpw/aligner.hpp"

namespace cv
{
namespace gcpw
{

/** @brief The straight lines and the borders of a photograph as curves of its picture on the canvas.

They are looked for before the base warper bends them.
@param corner canvas position of the picture's top-left pixel
@param megapix size at which lines are looked for, 10^6 px */
KnownLines warpedLines(const Mat& image, cv::detail::RotationWarper& warper, const Mat& K, const Mat& R, Point corner,
                       double megapix);

} // namespace gcpw
} // namespace cv

#endif
