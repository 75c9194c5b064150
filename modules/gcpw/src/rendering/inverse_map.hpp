// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#ifndef OPENCV_GCPW_INVERSE_MAP_HPP
#define OPENCV_GCPW_INVERSE_MAP_HPP

#include "geometry/frame_scale.hpp"
#include "model/mesh_grid.hpp"
#include "rendering/canvas_view.hpp"

namespace cv
{
namespace gcpw
{

/// Full-resolution canvas rectangle that holds every pixel whose centre the mesh covers: whole numbers, however large.
Rect2d coveredBounds(const MeshGrid& mesh, const FrameScale& canvas);

/** @brief The same in int. @throws cv::Exception StsOutOfRange if the mesh reaches farther than 1e9 px or is not finite */
Rect coveredRect(const MeshGrid& mesh, const FrameScale& canvas);

/** @brief For every canvas pixel of `roi`, which point of the source it shows.
@param mesh in work pixels on both sides
@param canvas, source scales of the two frames
@param roi full-resolution canvas pixels
@param map CV_32FC2 of roi's size: full-resolution source position; (-1, -1) where the mesh does not cover the centre
@param mask CV_8UC1 of roi's size: 255 exactly where the mesh covers the pixel's centre
@param view of the full-resolution canvas, with positive depth all over the mesh: roi then lies in its picture */
void buildInverseMap(const MeshGrid& mesh, const FrameScale& canvas, const FrameScale& source, Rect roi, Mat& map,
                     Mat& mask, const CanvasView& view = CanvasView());

/// The mesh with its vertices where a view of the full-resolution canvas shows them; a quad's inside is only nearly bilinear there.
MeshGrid viewed(const MeshGrid& mesh, const FrameScale& canvas, const CanvasView& view);

/// Rectangle of a view's picture that holds every pixel whose centre the mesh covers: whole numbers, however large.
Rect2d viewedBounds(const MeshGrid& mesh, const FrameScale& canvas, const CanvasView& view);

} // namespace gcpw
} // namespace cv

#endif
