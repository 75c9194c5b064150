// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#ifndef OPENCV_GCPW_ROUGH_ALIGNMENT_HPP
#define OPENCV_GCPW_ROUGH_ALIGNMENT_HPP

#include "registration/keypoints.hpp"
#include "registration/segments.hpp"

namespace cv
{
namespace gcpw
{

const int MIN_MATCHES = 8; ///< inliers below which a homography of two photographs may be chance

/// The homography that roughly aligns image a to image b, and how it was found.
struct RoughAlignment
{
    Matx33d b_from_a = Matx33d::eye();
    int tentative = 0; ///< keypoint matches tried
    int inliers = 0;   ///< that agree with the homography; 0 if that is not plausible
    bool found = false;
};

/** @brief Global homography by dual features @cite li2015dual, robustly.

RANSAC over keypoint matches, then re-weighted fits to points and to the segments that the homography itself pairs up.
@param size_a of the reference image a, for the plausibility of the result */
RoughAlignment alignRoughly(const Keypoints& keypoints_a, const Keypoints& keypoints_b,
                            const std::vector<Segment>& segments_a, const std::vector<Segment>& segments_b, Size size_a);

} // namespace gcpw
} // namespace cv

#endif
