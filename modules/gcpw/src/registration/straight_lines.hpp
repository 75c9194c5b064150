// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#ifndef OPENCV_GCPW_STRAIGHT_LINES_HPP
#define OPENCV_GCPW_STRAIGHT_LINES_HPP

#include <vector>
#include "geometry/segment.hpp"

namespace cv
{
namespace gcpw
{

/** @brief The straight lines of an image that are long enough to be seen to bend, longest first, in its pixels.
@param image CV_8UC3  @param mask CV_8UC1 of its size, lines only where non-zero; empty means everywhere */
std::vector<Segment> findStraightLines(const Mat& image, const Mat& mask);

/// The four borders of an image, through the centres of its outermost pixels, in its pixels.
std::vector<Segment> bordersOf(Size image);

/** @brief The long straight lines that an image shows in pieces: segments on one line are joined, and of lines side by side the
longest stands for all.
@param segments reference px, in any direction
@param min_length of a line that is kept, reference px
@return longest first */
std::vector<Segment> joinSegments(const std::vector<Segment>& segments, double min_length);

} // namespace gcpw
} // namespace cv

#endif
