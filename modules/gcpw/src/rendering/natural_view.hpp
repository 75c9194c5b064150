// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#ifndef OPENCV_GCPW_NATURAL_VIEW_HPP
#define OPENCV_GCPW_NATURAL_VIEW_HPP

#include <vector>
#include "model/mesh_grid.hpp"

namespace cv
{
namespace gcpw
{

/// A photograph on the canvas: its mesh in canvas pixels, its size in pixels of its own. Both at full resolution.
struct PlacedPhotograph
{
    MeshGrid mesh;
    Size size;
};

/** @brief The homography of the canvas that leaves the photographs most like themselves.

With J the Jacobian of view o mesh at the centre of a quad and s1, s2 its singular values, the view minimises
    E = sum_i mean_q [ 1/2 (ln s1 - ln s2)^2 + 1/2 (ln s1 s2 - mean_q ln s1 s2)^2 ]
over the quads q of each photograph i: logarithmic (Hencky) strain, less the scale of the whole photograph. E is 0 where the view
is a similarity of each photograph. It stretches each alike where a photograph's own frame would leave it alone and stretch the
other. As one homography carries all of them, what lay on each other still does, and what was straight stays straight.

E leaves a similarity open. Its scale keeps the area of all photographs together, each counted by the geometric mean over its
quads. Its turn is half of what lies between the first
and the last one, less whole quarter turns (a camera held upright or on its side), counted from the last, which is taken as
upright. Its shift is that of the centre of all quads to the origin.

@param photographs quads that are folded are left out
@return view from canvas, full-resolution pixels on both sides; the identity if no quad is left */
Matx33d naturalView(const std::vector<PlacedPhotograph>& photographs);

/// How much a view enlarges a pixel of any photograph at most, in any direction; quads that are folded are left out.
double largestStretch(const Matx33d& view, const std::vector<PlacedPhotograph>& photographs);

} // namespace gcpw
} // namespace cv

#endif
