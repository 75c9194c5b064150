// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#ifndef GCPW_APPS_REPORT_PANORAMA_PAGE_HPP
#define GCPW_APPS_REPORT_PANORAMA_PAGE_HPP

#include <opencv2/gcpw/rig.hpp>
#include "report/page.hpp"
#include "report/recorded_seams.hpp"
#include "report/warped_photographs.hpp"

namespace report
{

/// A picture that was composed, and by what.
struct Composed
{
    cv::Mat picture; ///< of 8 or 16 bits, neither turned nor cropped; empty if there is none
    cv::Ptr<cv::WarperCreator> warper;
    cv::Ptr<cv::detail::ExposureCompensator> compensator;
    cv::Ptr<RecordedSeams> seams; ///< the seam finder
};

/// A panorama that was stitched, or could not be.
struct PanoramaRun
{
    std::string program;
    std::string method; ///< as a reader says it
    std::string status; ///< one sentence
    std::vector<std::string> paths;
    Cameras cameras;
    double compose_scale = 1;           ///< pixels of the picture per pixel of the photographs
    Composed shown;                     ///< the picture
    Composed plain;                     ///< by OpenCV alone, to compare with; empty if `shown` is that
    const cv::gcpw::Rig* rig = nullptr; ///< null without GCPW
    int turns = 0;                      ///< to the right, by 90 degrees, that make the picture stand
    cv::Rect crop;                      ///< the part of the standing picture that was written; empty for all of it
    std::vector<Timing> timings;
    std::vector<std::string> messages;
};

/// A page that compares with the plain picture.
Page pageOf(const PanoramaRun& run);

} // namespace report

#endif
