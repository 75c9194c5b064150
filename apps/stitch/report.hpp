// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#ifndef GCPW_APPS_STITCH_REPORT_HPP
#define GCPW_APPS_STITCH_REPORT_HPP

#include <string>
#include "stitch/layout.hpp"

/// Milliseconds of wall time by stage.
struct Stages
{
    double read = 0;
    double cameras = 0;
    double compose = 0;

    double total() const { return read + cameras + compose; }
};

/** @brief The JSON of --report.
@param paths of all photographs that were read
@param size of the picture; 0 x 0 if there is none */
std::string reportText(const StitchJob& job, const std::vector<std::string>& paths, const Layout& layout,
                       const Stages& stages, cv::Size size);

#endif
