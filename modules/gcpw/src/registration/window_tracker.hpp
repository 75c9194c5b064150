// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#ifndef OPENCV_GCPW_WINDOW_TRACKER_HPP
#define OPENCV_GCPW_WINDOW_TRACKER_HPP

#include "registration/gray_pyramid.hpp"

namespace cv
{
namespace gcpw
{

/// Where a place of one image is expected in another, and how its surroundings are mapped there.
struct ExpectedPlace
{
    Point2d at;                   ///< px of the other image
    Matx22d map = Matx22d::eye(); ///< d other image / d image there
};

/// Where it was found.
struct FoundPlace
{
    Point2d at;             ///< px of the other image
    double correlation = 0; ///< zero-mean, of both windows on the finest level, -1..1
};

/** @brief Follows a place from image a to image b, coarse to fine (Lucas and Kanade; inverse compositional).

The window of a is resampled as b is expected to show it, then moved over b until their squared difference is least. Gain and bias
of the window are eliminated from it, so that exposure does not matter.
@param from px of a  @param expected in b
@param levels number of levels, >= 1; each more doubles what it bridges, a quarter of a window on the finest alone
@param found receives the place  @return false where texture or image end */
bool follow(const GrayPyramid& a, Point2d from, const GrayPyramid& b, const ExpectedPlace& expected, int levels,
            FoundPlace& found);

} // namespace gcpw
} // namespace cv

#endif
