// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#ifndef GCPW_APPS_REPORT_PAIR_PAGE_HPP
#define GCPW_APPS_REPORT_PAIR_PAGE_HPP

#include <opencv2/gcpw/pair.hpp>
#include "report/page.hpp"

namespace report
{

/// A pair that was stitched, or could not be.
struct PairRun
{
    std::string program;
    std::string method;             ///< as a reader says it
    std::vector<std::string> paths; ///< of source and target
    cv::Mat source;                 ///< as it is shown
    cv::Mat target;
    cv::gcpw::Alignment alignment;
    cv::gcpw::View view = cv::gcpw::View::NATURAL;
    cv::gcpw::Blend blend = cv::gcpw::Blend::MULTIBAND;
    cv::gcpw::PairCanvas canvas; ///< of the alignment in this view; empty without an alignment
    cv::Mat panorama;            ///< of this canvas, as a whole
    cv::Rect crop;               ///< the part of it that was written; empty for all of it
    Scores zncc;                 ///< of the homography and of the alignment
    double render_ms = 0;
};

/// A page that compares the alignment with its homography.
Page pageOf(const PairRun& run);

} // namespace report

#endif
