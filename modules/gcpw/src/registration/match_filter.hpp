// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#ifndef OPENCV_GCPW_MATCH_FILTER_HPP
#define OPENCV_GCPW_MATCH_FILTER_HPP

#include "geometry/matches.hpp"
#include "model/mesh_grid.hpp"

namespace cv
{
namespace gcpw
{

/// How filterMatches() narrows its robust loss (lengths in canvas px), and what it keeps.
struct MatchFilterSchedule
{
    double start_px = 30; ///< scale of the first fit: wide enough to follow parallax
    double end_px = 2.5;  ///< scale of the last fit
    double factor = 0.6;  ///< of the scale from fit to fit
    double keep_px = 4;   ///< matches farther from the last mesh are dropped
    double similarity_weight = 0.2; ///< a softer mesh would follow what it is to reject
};

enum class MatchFilterStatus
{
    Fitted,
    Folded,  ///< the mesh that follows the matches folds
    Unsolved ///< the fit has no solution
};

/** @brief Rejects outliers among point matches: those that one mesh cannot follow.

A mesh is fitted to all matches with a Geman-McClure loss whose scale falls as `schedule` says; matches that the final mesh does
not follow are dropped.
@param matches a: reference px of the moving image, b: reference px of the fixed one; filtered in place, and empty if Unsolved: then no
match is verified
@param moving the mesh to start from; receives the fitted mesh if Fitted, else it stays as it was
@param rough whose quads keep their shape  @param fixed mesh of the fixed image
@param shift_fixed canvas px by which it is seen beside its own place */
[[nodiscard]] MatchFilterStatus filterMatches(std::vector<PointMatch>& matches, MeshGrid& moving, const MeshGrid& rough,
                                       const MeshGrid& fixed, Point2d shift_fixed, const MatchFilterSchedule& schedule);

} // namespace gcpw
} // namespace cv

#endif
