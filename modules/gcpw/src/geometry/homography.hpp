// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#ifndef OPENCV_GCPW_HOMOGRAPHY_HPP
#define OPENCV_GCPW_HOMOGRAPHY_HPP

#include "geometry/matches.hpp"

namespace cv
{
namespace gcpw
{

/// H p, inhomogeneous. Not finite on the horizon, where the third coordinate of H p is 0.
Point2d applyHomography(const Matx33d& h, Point2d p);

/** @brief b from a by points and lines together @cite li2015dual (direct linear transform).

A point match gives b x H a = 0 (two rows), a line match l_b^T H p = 0 for both ends p of its segment in a. Both frames
are normalised first; rows are weighted by the matches' weights.
@return false if fewer than four points' worth of rows are given or they do not fix a homography */
bool fitHomography(const std::vector<PointMatch>& points, const std::vector<LineMatch>& lines, Matx33d& b_from_a);

/** @brief Whether a homography keeps a whole image upright and finite, and collapses no direction of it.
@return true if on all four corners its Jacobian's determinant is positive and at most max_zoom^2, and no direction shrinks by
more than max_zoom */
bool isPlausible(const Matx33d& h, Size image_size, double max_zoom);

} // namespace gcpw
} // namespace cv

#endif
