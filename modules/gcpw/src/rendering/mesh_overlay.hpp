// Part of the GCPW module for OpenCV. Licence: Apache-2.0 (see LICENSE).
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
