// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#ifndef OPENCV_GCPW_CURVE_HPP
#define OPENCV_GCPW_CURVE_HPP

#include <vector>
#include <opencv2/core.hpp>

namespace cv
{
namespace gcpw
{

/// An image of a straight edge: its points in order. Straight in a photograph, bent where a sphere or cylinder has bent that.
typedef std::vector<Point2d> Curve;

const double MAX_SAMPLES = 10000; ///< of a line: no image that fits into memory has longer ones at the default steps

/// Length of the polygon through the points.
double lengthOf(const Curve& curve);

/// Points of the polygon at equal distances of about step_px, both ends among them; none of a curve without length.
Curve resampled(const Curve& curve, double step_px);

} // namespace gcpw
} // namespace cv

#endif
