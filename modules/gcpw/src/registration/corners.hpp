// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#ifndef OPENCV_GCPW_CORNERS_HPP
#define OPENCV_GCPW_CORNERS_HPP

#include <vector>
#include <opencv2/core.hpp>

namespace cv
{
namespace gcpw
{

/** @brief Corners (Shi and Tomasi) spread evenly over an image: the strongest of each square, if it has any.

@param gray CV_8UC1  @param mask CV_8UC1 of its size, corners only where non-zero; empty means everywhere
@param spacing px, > 0: side of the squares
@return pixels, row by row of squares */
std::vector<Point> findCorners(const Mat& gray, const Mat& mask, int spacing);

} // namespace gcpw
} // namespace cv

#endif
