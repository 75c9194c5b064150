// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#ifndef OPENCV_GCPW_OUTSIDE_CURVES_HPP
#define OPENCV_GCPW_OUTSIDE_CURVES_HPP

#include "geometry/curve.hpp"
#include "overlap/neighbour.hpp"

namespace cv
{
namespace gcpw
{

/** @brief The parts of a curve that no neighbour shows.
@param mesh of the image whose pixels the curve is in  @param step_px between the points at which it is looked for, > 0
@param min_length of a part that is kept, px  @param margin_px as isShown() has it
@return in order; the curve resampled where all of it is one part */
std::vector<Curve> partsOutside(const Curve& curve, const MeshGrid& mesh, const std::vector<Neighbour>& neighbours,
                                double step_px, double min_length, double margin_px);

} // namespace gcpw
} // namespace cv

#endif
