// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#ifndef GCPW_APPS_STITCH_SETUP_HPP
#define GCPW_APPS_STITCH_SETUP_HPP

#include <functional>
#include <string>
#include <vector>
#include <opencv2/gcpw/cameras.hpp>
#include <opencv2/stitching.hpp>
#include "stitch/match_log.hpp"

/// How a panorama is made, in the words of OpenCV's stitching_detailed.
struct StitchSetup
{
    std::string mode = "auto";
    std::string warp; ///< empty: spherical for panorama, affine for scans, chosen for auto
    std::string features = "sift";
    std::string matcher;   ///< empty: affine for scans, else homography
    std::string estimator; ///< the same
    std::string seam = "gcpw";
    std::string blend = "multiband";
    std::string expos_comp = "gain_blocks";
    std::string ba; ///< empty: affine for scans, else ray
    std::string ba_refine_mask = "xxxxx";
    std::string wave_correct; ///< empty: horiz for panorama
    double work_megapix = 0.6;
    double seam_megapix = 0.1;
    double compose_megapix = -1;
    double conf_thresh = 1;
    double match_conf = -1;     ///< -1: as stitching_detailed has it for the kind of features
    double blend_strength = -1; ///< -1: as cv::Stitcher has it
    int range_width = -1;
    int expos_comp_nr_feeds = 1;
    int expos_comp_nr_filtering = 2;
    int expos_comp_block_size = 32;
};

// The names that there are.
std::vector<std::string> warpNames();
std::vector<std::string> featureNames();
std::vector<std::string> seamNames();
std::vector<std::string> compensatorNames();

/// Throws WrongUse if an option does not belong to the mode, or this OpenCV lacks what is asked for.
void checkSetup(const StitchSetup& setup);

/// The warper of a name. Throws WrongUse that lists them.
cv::Ptr<cv::WarperCreator> warperOf(const std::string& name);

/// How cv::gcpw::estimateCameras() looks for cameras in mode auto.
cv::gcpw::CameraOptions cameraOptions(const StitchSetup& setup, MatchLog& log);

/// A stitcher of OpenCV's own classes, for the estimation. @param log outlives it
cv::Ptr<cv::Stitcher> makeStitcher(const StitchSetup& setup, MatchLog& log);

/// @param show called with the share of the cuts that are done, by those finders that can tell; may be empty
cv::Ptr<cv::detail::SeamFinder> seamFinderOf(const StitchSetup& setup, const std::function<void(double)>& show);

/// The cut that OpenCV alone makes: cv::Stitcher's default in the place of "gcpw".
std::string plainSeam(const std::string& seam);
cv::Ptr<cv::detail::ExposureCompensator> compensatorOf(const StitchSetup& setup);

/// How photographs are mixed along the cuts of a picture.
struct Blending
{
    enum Kind
    {
        NONE,
        FEATHER,
        BANDS
    };
    Kind kind = NONE;
    int bands = 0;       ///< of BANDS
    float sharpness = 0; ///< of FEATHER: weight a pixel from the border
};

/// @param area px, of the picture
Blending blendingOf(const StitchSetup& setup, double area);

/// A blender of OpenCV's own for a part of such a picture.
cv::Ptr<cv::detail::Blender> blenderOf(const Blending& blending);

/** @brief The blender of a picture.
@param area px, of the picture  @param deep for 16 bits, see compose() */
cv::Ptr<cv::detail::Blender> blenderOf(const StitchSetup& setup, double area, bool deep);

#endif
