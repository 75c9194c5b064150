// Part of the GCPW module for OpenCV. Licence: Apache-2.0 (see LICENSE).
#ifndef OPENCV_GCPW_MATCH_GATE_HPP
#define OPENCV_GCPW_MATCH_GATE_HPP

#include "geometry/matches.hpp"
#include "model/mesh_grid.hpp"

namespace cv
{
namespace gcpw
{

/** @brief Tells good point matches from wrong ones by what one mesh can follow.

A mesh is fitted to all matches with a Geman-McClure loss whose scale falls from `start_px` to `end_px`: wide enough at
first to follow parallax, strict at the end. Matches farther than `keep_px` from the final mesh are dropped.
@param matches a: rest px of the moving image, b: rest px of the fixed one; filtered in place
@param moving the mesh to start from; receives the fitted mesh
@param fixed mesh of the fixed image  @param shift_fixed canvas px by which it is seen beside its own place
@return false if the fit is singular; nothing is changed then */
struct GateSchedule
{
    double start_px = 30;
    double end_px = 2.5;
    double factor = 0.6; ///< of the scale from fit to fit
    double keep_px = 4;
    double similarity_weight = 0.2;
};
bool gateMatches(std::vector<PointMatch>& matches, MeshGrid& moving, const MeshGrid& rough, const MeshGrid& fixed,
                 Point2d shift_fixed, const GateSchedule& schedule);

} // namespace gcpw
} // namespace cv

#endif
