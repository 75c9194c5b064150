// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#ifndef GCPW_APPS_STITCH_SETUP_HPP
#define GCPW_APPS_STITCH_SETUP_HPP

#include <opencv2/gcpw/cameras.hpp>
#include <opencv2/stitching.hpp>
#include <string>

/// How a panorama is made, in the words of OpenCV's stitching_detailed.
struct StitchSetup
{
    std::string mode = "auto";
    std::string warp; ///< empty: spherical for panorama, affine for scans, chosen for auto
    std::string features = "sift";
    std::string seam = "gc_color";
    std::string blend = "multiband";
    std::string expos_comp = "gain_blocks";
    std::string ba;           ///< empty: ray for panorama
    std::string wave_correct; ///< empty: horiz for panorama
    double work_megapix = 0.6;
    double seam_megapix = 0.1;
    double compose_megapix = -1;
    double conf_thresh = 1;
    double match_conf = 0.65;
    int range_width = -1;
};

/// Throws WrongUse if a name is unknown or an option does not belong to the mode.
void checkSetup(const StitchSetup& setup);

/// How cv::gcpw::estimateCameras() looks for cameras in mode auto.
cv::gcpw::CameraOptions cameraOptions(const StitchSetup& setup);

/// A stitcher of OpenCV's own classes. Throws WrongUse that lists the names there are.
cv::Ptr<cv::Stitcher> makeStitcher(const StitchSetup& setup);

/// What a status of cv::Stitcher means to the user.
std::string explain(cv::Stitcher::Status status);

#endif
