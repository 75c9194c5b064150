// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#ifndef OPENCV_GCPW_KEYPOINTS_HPP
#define OPENCV_GCPW_KEYPOINTS_HPP

#include <vector>
#include <opencv2/core.hpp>
#include "geometry/matches.hpp"
#include "registration/prediction.hpp"

namespace cv
{
namespace gcpw
{

/// Keypoints of an image, strongest first.
struct Keypoints
{
    std::vector<Point2d> points; ///< reference pixels
    Mat descriptors;             ///< points.size() x 128, CV_8U
};

/** @brief SIFT keypoints of an image.
@param gray CV_8UC1  @param mask CV_8UC1 of its size, keypoints only where non-zero; empty means everywhere
@param to_reference from pixels of `gray` to reference pixels: reference = (p + 0.5) * to_reference - 0.5
@param contrast_threshold of SIFT; OpenCV's 0.04 loses most keypoints of a dark photograph */
Keypoints detectKeypoints(const Mat& gray, const Mat& mask, Size2d to_reference, double contrast_threshold);

/// A match found, with the index of its keypoints and its quality.
struct KeypointMatch
{
    int a = -1;
    int b = -1;
    float ratio = 1; ///< best distance over second best, 0..1
};

/// Mutual nearest descriptors that pass the ratio test, among the `strongest` keypoints of each image.
std::vector<KeypointMatch> matchEverywhere(const Keypoints& a, const Keypoints& b, int strongest, double max_ratio);

/** @brief Mutual nearest descriptors among those keypoints of b that lie near where a's keypoint is expected.
@param radius how far from there to look, px
@param max_ratio of the best to the second best distance among the candidates that are not the same spot */
std::vector<KeypointMatch> matchNearby(const Keypoints& a, const Keypoints& b, const Prediction& b_from_a, double radius,
                                       double max_ratio);

/// The matches as points.
std::vector<PointMatch> toPointMatches(const Keypoints& a, const Keypoints& b, const std::vector<KeypointMatch>& matches);

} // namespace gcpw
} // namespace cv

#endif
