// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#ifndef OPENCV_GCPW_RIG_COLORS_HPP
#define OPENCV_GCPW_RIG_COLORS_HPP

#include "rendering/color_field.hpp"
#include "stitching/rig_model.hpp"

namespace cv
{
namespace gcpw
{

/** @brief Where the pixels of a warped picture lie on the colour grid of their image.
@param index of the image  @param scale of the warper that made the picture, canvas px per radian
@param picture its rectangle on the canvas
@param grid columns and rows of the colours
@return for pixels of the picture, from its corner. It keeps what it needs */
GridPosition positionOnColors(const RigModel& model, int index, double scale, Rect picture, Size grid);

} // namespace gcpw
} // namespace cv

#endif
