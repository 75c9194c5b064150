// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#ifndef OPENCV_GCPW_FEATURES_HPP
#define OPENCV_GCPW_FEATURES_HPP

#include <vector>
#include "opencv2/gcpw/params.hpp"
#include "registration/gray_pyramid.hpp"
#include "registration/keypoints.hpp"
#include "registration/segments.hpp"

namespace cv
{
namespace gcpw
{

/// What one image has to be matched by, in reference pixels.
struct Features
{
    Keypoints keypoints;
    std::vector<Segment> segments;
    std::vector<Point> corners; ///< to be followed to another image
    GrayPyramid pyramid;        ///< in which corners are found again; without levels they are not followed
};

/** @brief Line segments of an image.
@param image CV_8UC3 at the resolution they are to be found at  @param mask CV_8UC1 of its size, may be empty
@param to_reference as for detectKeypoints() */
std::vector<Segment> segmentsOf(const Mat& image, const Mat& mask, Size2d to_reference);

/// SIFT keypoints of an image; the same arguments.
Keypoints keypointsOf(const Mat& image, const Mat& mask, Size2d to_reference, const Params& params);

/** @brief Gives features what following corners needs (Params::cornerTracking): four corners a quad of the mesh.
@param image CV_8UC3, the reference pixels themselves  @param mask CV_8UC1 of its size, may be empty */
void prepareCorners(const Mat& image, const Mat& mask, const Params& params, Features& features);

} // namespace gcpw
} // namespace cv

#endif
