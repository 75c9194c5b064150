// Part of the GCPW module for OpenCV. Licence: Apache-2.0 (see LICENSE).
#ifndef OPENCV_GCPW_PAIR_MATCHER_HPP
#define OPENCV_GCPW_PAIR_MATCHER_HPP

#include "registration/keypoints.hpp"
#include "registration/segments.hpp"
#include "model/mesh_grid.hpp"
#include "opencv2/gcpw/params.hpp"
#include "energy/term_list.hpp"

namespace cv
{
namespace gcpw
{

/// Keypoints and line segments of one image, in reference pixels.
struct Features
{
    Keypoints keypoints;
    std::vector<Segment> segments;
};

/** @brief Features of an image.
@param image CV_8UC3 at the resolution they are to be found at  @param mask CV_8UC1 of its size, may be empty
@param work_size reference frame */
Features detectFeatures(const Mat& image, const Mat& mask, Size work_size, const Params& params);

/// The same where the keypoints are known; `image` and `mask` are at the working resolution.
Features knownFeatures(const Mat& image, const Mat& mask, const Keypoints& keypoints);

/** @brief All matches between a moving image and a fixed one, verified by a mesh.

Keypoints are matched near where the rough mesh expects them and gated by a robust mesh fit, then matched once more near
where that mesh expects them (Params::guidedMatching; not if it folds). Line segments are paired and verified by the points'
mesh, or by the rough one where that folds. There are no matches if no mesh fits them.
@param rough rough mesh of a  @param fixed rough mesh of b  @param shift_b see ProblemPair */
MatchSet matchPair(const Features& a, const Features& b, const MeshGrid& rough, const MeshGrid& fixed, Point2d shift_b,
                   const Params& params, const TermList& terms_used);

} // namespace gcpw
} // namespace cv

#endif
