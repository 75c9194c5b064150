// Part of the GCPW module for OpenCV. Licence: Apache-2.0 (see LICENSE).
#ifndef OPENCV_GCPW_COLOR_FIELD_HPP
#define OPENCV_GCPW_COLOR_FIELD_HPP

#include <functional>
#include <opencv2/core.hpp>

namespace cv
{
namespace gcpw
{

/** @brief Corrects a picture by the colour grid of its image, at any scale.

A colour grid bends over tens of pixels: the map is evaluated on every 8th pixel, as an affine map of BGR, and is bilinear in
between.
@param picture CV_8UC3 or CV_8UC1, changed in place
@param color rows x cols, CV_32FC(6), as in Alignment::Image
@param grid_at position of a pixel on the grid, in quads from the top left corner (0..cols, 0..rows) */
void correctPicture(Mat& picture, const Mat& color, const std::function<Point2d(Point2d)>& grid_at);

} // namespace gcpw
} // namespace cv

#endif
