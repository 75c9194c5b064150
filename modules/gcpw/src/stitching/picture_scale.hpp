// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#ifndef OPENCV_GCPW_PICTURE_SCALE_HPP
#define OPENCV_GCPW_PICTURE_SCALE_HPP

#include <vector>
#include "stitching/rig_model.hpp"

namespace cv
{
namespace gcpw
{

/** @brief The scale of the warper that made a picture, found from where the picture lies.

The mesh of an image covers its picture, and grows with the scale: the four edges of the picture are the mesh's times the scale.
@param index of the image  @param picture its rectangle on the canvas, or that of a part of it
@param made scales of warpers, latest first: the one that fits is the answer, exactly. Where none does, and where there are
none, the scale that fits best. */
double pictureScale(const RigModel& model, int index, Rect picture, const std::vector<float>& made);

} // namespace gcpw
} // namespace cv

#endif
