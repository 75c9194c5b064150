// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#ifndef GCPW_APPS_REPORT_SVG_HPP
#define GCPW_APPS_REPORT_SVG_HPP

#include <string>
#include <vector>
#include "report/picture.hpp"

namespace report
{

/** @brief Paths as the data of one SVG path, in pixels of a frame.

Points that lie within a fifth of a pixel of the straight line between others are left out, and paths wholly beside the frame.
@param paths canvas pixels  @param frame canvas rectangle whose top-left corner is 0, 0 */
std::string pathData(const std::vector<Path>& paths, const cv::Rect& frame);

/// The lines between pixels that show different images, as the data of one SVG path.
std::string cutData(const evaluation::Labels& labels, const cv::Rect& frame);

/// For each of `count` images the pixel of the frame that lies deepest in what is seen of it; none outside if nothing is: then
/// x is -1.
std::vector<cv::Point> middles(const evaluation::Labels& labels, size_t count, const cv::Rect& frame);

} // namespace report

#endif
