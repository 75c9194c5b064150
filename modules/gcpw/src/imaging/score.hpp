// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#ifndef OPENCV_GCPW_SCORE_HPP
#define OPENCV_GCPW_SCORE_HPP

#include "opencv2/gcpw/alignment.hpp"

namespace cv
{
namespace gcpw
{

/** @brief Scores the overlap of two images.
@param a, b CV_8UC3 BGR of one size  @param mask CV_8UC1, non-zero where both have content; its border of 3 px is left out */
Score scoreOverlap(const Mat& a, const Mat& b, const Mat& mask);

} // namespace gcpw
} // namespace cv

#endif
