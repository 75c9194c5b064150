// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#ifndef GCPW_APPS_MODEL_CHECK_HPP
#define GCPW_APPS_MODEL_CHECK_HPP

#include <opencv2/gcpw/rig.hpp>
#include <opencv2/stitching.hpp>
#include <string>
#include <vector>

/** @brief Which of the images a model's cameras are of. Throws WrongUse if the images cannot be those of the model: their number or
sizes differ.
@param images photographs as given  @param name of the model's file, for the message */
std::vector<int> checkModel(const cv::gcpw::Rig& rig, const std::vector<cv::Mat>& images, const std::string& name);

/// Throws WrongUse if the stitcher takes the cameras at another resolution than the model was made at.
void checkWorkScale(const cv::gcpw::Rig& rig, const cv::Stitcher& stitcher, const std::string& name);

#endif
