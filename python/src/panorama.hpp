// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#ifndef GCPW_PYTHON_PANORAMA_HPP
#define GCPW_PYTHON_PANORAMA_HPP

#include <opencv2/gcpw/rig.hpp>
#include <string>
#include <vector>
#include "calls.hpp"

/// A finished picture, and how it came about.
struct Panorama
{
    cv::Mat picture;                    ///< CV_8UC3
    cv::Mat mask;                       ///< CV_8UC1 of the same size, 255 where a photograph covers the picture
    cv::gcpw::Rig rig;                  ///< usable() if GCPW made it, else OpenCV's warper alone
    std::vector<int> used;              ///< photographs in the picture, from 0
    std::vector<std::string> decisions; ///< one sentence for each choice that was made
};

/// One photograph as a rig shows it.
struct Warped
{
    cv::Point corner; ///< canvas position of the top-left pixel
    cv::Mat picture;  ///< of the photograph's type, mirrored beside the mesh
    cv::Mat mask;     ///< CV_8UC1 of the same size, 255 inside
};

/** @brief Cameras, meshes, colours and picture of a set of photographs.
@param photographs two or more, see bgrOf()
@param projection name of a warper, empty: chosen
@param megapix size of the photographs in the picture, million pixels; 0 or less keeps their own
@throws NoAlignment if they do not match */
Panorama stitchPhotographs(const std::vector<cv::Mat>& photographs, const cv::gcpw::Params& params, const std::string& projection,
                           double megapix, Watch& watch);

/// The picture of further photographs of a rig's cameras. Throws cv::Exception that names a photograph that is none.
Panorama stitchByRig(const cv::gcpw::Rig& rig, const std::vector<cv::Mat>& photographs, double megapix, Watch& watch);

/// Warps one photograph of a rig's cameras, at its own resolution.
Warped warpByRig(const cv::gcpw::Rig& rig, int index, const cv::Mat& photograph);

#endif
