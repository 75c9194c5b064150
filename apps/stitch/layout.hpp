// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#ifndef GCPW_APPS_STITCH_LAYOUT_HPP
#define GCPW_APPS_STITCH_LAYOUT_HPP

#include <string>
#include <vector>
#include <opencv2/gcpw/cameras.hpp>
#include <opencv2/gcpw/stitcher.hpp>
#include "common/progress_line.hpp"
#include "common/read_photograph.hpp"
#include "stitch/job.hpp"

/// Where photographs lie in a picture, and by what they are put there.
struct Layout
{
    std::vector<int> component;                    ///< which of the photographs have a camera, 0-based
    std::vector<cv::detail::CameraParams> cameras; ///< of these, at the resolution of the estimation
    double work_scale = 1;                         ///< pixels of the estimation per pixel of the photographs
    std::string projection;                        ///< name of the warper
    bool turned = false;                           ///< the picture comes out turned to the left
    std::vector<std::string> decisions;            ///< one sentence for each choice that was made
    std::string trouble;                           ///< why there are no cameras; empty if there are

    cv::Ptr<cv::WarperCreator> warper; ///< with the meshes of the rig
    cv::Ptr<cv::detail::ExposureCompensator> compensator;
    cv::Ptr<cv::detail::SeamFinder> seam_finder;
    cv::gcpw::Rig rig;   ///< of GCPW; without cameras if there is none
    int estimations = 0; ///< of the alignment so far

    bool ok() const { return trouble.empty(); }
};

/// Stages of the work in ProgressLine.
extern const char* const READING;
extern const char* const MATCHING;
extern const char* const ALIGNING;
extern const char* const SEAMS;
extern const char* const COMPOSING;

/// What of SEAMS is done before the first cut: photographs are warped.
const double SHARE_BEFORE_CUTS = 0.3;

/** @brief Looks for cameras, or takes those of a model, and aligns.
@param photographs two or more
@param log gets the matches, and outlives the layout */
Layout layOut(const StitchJob& job, const std::vector<Photograph>& photographs, MatchLog& log, ProgressLine& progress);

#endif
