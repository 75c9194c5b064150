// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#ifndef OPENCV_GCPW_PAIR_MATCHER_HPP
#define OPENCV_GCPW_PAIR_MATCHER_HPP

#include "registration/keypoints.hpp"
#include "registration/segments.hpp"
#include "model/mesh_grid.hpp"
#include "opencv2/gcpw/params.hpp"

namespace cv
{
namespace gcpw
{

/// Which matches of two images are wanted.
struct MatchKinds
{
    bool points = false;
    bool lines = false; ///< only beside points, whose mesh verifies them
};

MatchKinds matchesUsedBy(Method method);

/// Keypoints and line segments of one image, in reference pixels.
struct Features
{
    Keypoints keypoints;
    std::vector<Segment> segments;
};

/** @brief Features of an image.
@param image CV_8UC3 at the resolution they are to be found at  @param mask CV_8UC1 of its size, may be empty
@param to_reference as for detectKeypoints() */
Features detectFeatures(const Mat& image, const Mat& mask, Size2d to_reference, const Params& params);

/// The same where the keypoints are known, in reference pixels.
Features knownFeatures(const Mat& image, const Mat& mask, Size2d to_reference, const Keypoints& keypoints);

/** @brief All matches between a moving image and a fixed one, verified by a mesh.

Keypoints are matched near where the rough mesh expects them and filtered by a robust mesh fit, then matched once more near
where that mesh expects them (Params::guidedMatching; not if it folds). Line segments are paired and verified by the points'
mesh, or by the rough one where that folds. There are no matches if no mesh fits them.
@param rough rough mesh of a  @param fixed rough mesh of b  @param shift_b see ProblemPair */
MatchSet matchPair(const Features& a, const Features& b, const MeshGrid& rough, const MeshGrid& fixed, Point2d shift_b,
                   const Params& params, MatchKinds kinds);

} // namespace gcpw
} // namespace cv

#endif
