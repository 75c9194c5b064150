// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#ifndef OPENCV_GCPW_MESH_OVERLAY_HPP
#define OPENCV_GCPW_MESH_OVERLAY_HPP

#include "rendering/inverse_map.hpp"

namespace cv
{
namespace gcpw
{

/// Draws the rows and columns of a mesh onto a picture of the canvas, CV_8UC3.
void drawMesh(const MeshGrid& mesh, const FrameScale& canvas, Point canvas_origin, Mat& picture);

} // namespace gcpw
} // namespace cv

#endif
