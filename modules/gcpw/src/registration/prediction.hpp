// Part of the GCPW module for OpenCV. Licence: Apache-2.0 (see LICENSE).
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
