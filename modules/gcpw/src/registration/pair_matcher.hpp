// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#ifndef OPENCV_GCPW_PAIR_MATCHER_HPP
#define OPENCV_GCPW_PAIR_MATCHER_HPP

#include "geometry/matches.hpp"
#include "model/mesh_grid.hpp"
#include "opencv2/gcpw/params.hpp"
#include "registration/features.hpp"

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

/** @brief All matches between a moving image and a fixed one, verified by a mesh.

Points are matched near where the rough mesh expects them and filtered by a robust mesh fit, then matched once more near
where that mesh expects them (Params::guidedMatching; not if it folds). If both images are prepared for it, corners of a are
followed to b; keypoints then only lead the first fit, where both have enough of them. Else keypoints are matched. Line segments are
paired and verified by the points' mesh, or by the rough one where that folds. There are no matches if no mesh fits them.
@param rough rough mesh of a  @param fixed rough mesh of b  @param shift_b see ProblemPair */
MatchSet matchPair(const Features& a, const Features& b, const MeshGrid& rough, const MeshGrid& fixed, Point2d shift_b,
                   const Params& params, MatchKinds kinds);

} // namespace gcpw
} // namespace cv

#endif
