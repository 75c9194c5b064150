// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#ifndef OPENCV_GCPW_PAIR_VIEW_HPP
#define OPENCV_GCPW_PAIR_VIEW_HPP

#include "model/mesh_grid.hpp"
#include "rendering/canvas_view.hpp"

namespace cv
{
namespace gcpw
{

/** @brief The view of View::NATURAL.

It is naturalView() where that hardly stretches the photographs. Else, where a camera that turned explains the pair, it is that of a
panorama: upright, straightened along the turn, on a plane, or on a sphere where a plane would stretch them, too (chooseProjection()).
@param source_mesh where the rough alignment has the source on the canvas, full-resolution pixels: a mesh follows parallax, which
looks like a turn
@param source, target sizes of the photographs; the canvas is the target's frame */
CanvasView pairView(const MeshGrid& source_mesh, Size source, Size target);

} // namespace gcpw
} // namespace cv

#endif
