// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#ifndef GCPW_APPS_PAIR_REPORT_HPP
#define GCPW_APPS_PAIR_REPORT_HPP

#include <string>
#include <opencv2/gcpw/pair.hpp>

/** @brief The JSON of --report.
@param before, after scores; null where nothing was rendered  @param render_ms wall time of the rendering */
std::string reportText(const cv::gcpw::Report& report, const std::string& method, const cv::gcpw::Score* before,
                       const cv::gcpw::Score* after, double render_ms);

#endif
