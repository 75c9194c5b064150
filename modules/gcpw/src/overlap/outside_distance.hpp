// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#ifndef OPENCV_GCPW_OUTSIDE_DISTANCE_HPP
#define OPENCV_GCPW_OUTSIDE_DISTANCE_HPP

#include <vector>
#include "overlap/neighbour.hpp"

namespace cv
{
namespace gcpw
{

/** @brief How far each quad lies from what a neighbour shows too: px of the image, between centres; 0 in the overlap.

All 0 if there is no overlap: then nothing pulls at the image. */
std::vector<double> distanceOutside(const MeshGrid& mesh, const std::vector<Neighbour>& neighbours);

} // namespace gcpw
} // namespace cv

#endif
