// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#ifndef OPENCV_GCPW_LINK_CHECK_HPP
#define OPENCV_GCPW_LINK_CHECK_HPP

#include <vector>
#include "cameras/linked_images.hpp"

namespace cv
{
namespace gcpw
{

/// What two photographs look like when one is laid on the other.
struct OverlapLook
{
    double share = 0;       ///< of the smaller image that the other covers
    double correlation = 0; ///< mean over small windows with something to see, -1..1
    int windows = 0;        ///< that were compared
};

/** @brief Lays image a on image b by a homography and correlates what both show, in windows of a few per cent of their width.
@param a, b 8-bit BGR or gray  @param b_from_a pixels */
OverlapLook lookAtOverlap(const Mat& a, const Mat& b, const Matx33d& b_from_a);

/** @brief Whether two photographs that matches hardly link do show the same: their homography is one that photographs have where
its matches are, and what it lays on each other looks alike.
@param inliers matches that the homography was found from, pixels of a */
bool showTheSame(const Mat& a, const Mat& b, const Matx33d& b_from_a, const std::vector<Point2f>& inliers);

/** @brief Raises the confidence of links that the pictures confirm, so that no photograph is dropped for want of matches alone.

Only pairs in different groups are looked at, and all of them: one link joins two groups, but only all of them close a ring.
@param pictures of the images, at the resolution of their keypoints  @param confidence that a link needs
@return the pairs that were joined */
std::vector<Vec2i> confirmLinks(LinkedImages& images, const std::vector<Mat>& pictures, double confidence);

} // namespace gcpw
} // namespace cv

#endif
