// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#ifndef OPENCV_GCPW_GUIDED_SEARCH_HPP
#define OPENCV_GCPW_GUIDED_SEARCH_HPP

#include <vector>
#include "geometry/matches.hpp"
#include "registration/gray_pyramid.hpp"
#include "registration/prediction.hpp"

namespace cv
{
namespace gcpw
{

/** @brief Follows corners of image a to where a prediction expects them in image b, and back.

A match is kept if the way back ends where it began, both windows look alike, and both images show both places.
@param corners px of a  @param levels see follow() */
std::vector<PointMatch> searchCorners(const GrayPyramid& a, const std::vector<Point>& corners, const GrayPyramid& b,
                                      const Prediction& b_from_a, int levels);

} // namespace gcpw
} // namespace cv

#endif
