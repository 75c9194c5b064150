// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#ifndef OPENCV_GCPW_PREDICTION_HPP
#define OPENCV_GCPW_PREDICTION_HPP

#include <functional>
#include <optional>
#include <opencv2/core.hpp>

namespace cv
{
namespace gcpw
{

/// Where a point of image a is expected in image b, each in its own reference pixels; nothing where b does not show it.
typedef std::function<std::optional<Point2d>(Point2d)> Prediction;

} // namespace gcpw
} // namespace cv

#endif
