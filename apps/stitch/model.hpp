// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#ifndef GCPW_APPS_STITCH_MODEL_HPP
#define GCPW_APPS_STITCH_MODEL_HPP

#include <string>
#include <vector>
#include <opencv2/gcpw/rig.hpp>
#include "common/read_photograph.hpp"

struct Layout;

/** @brief Reads a saved model for these photographs, in the order in which those were given that it was made of.

Photographs of another size than those, but of one shape, are taken as the same scaled: work_scale is set for them.
@param path of the model
@param warp the warper that was asked for, empty for the model's own
@return with component, work_scale and projection
@throws FileTrouble if it cannot be read
@throws WrongUse if it is of other photographs (their number or shape) or of another warper */
cv::gcpw::Rig modelFor(const std::vector<Photograph>& photographs, const std::string& path, const std::string& warp);

/// Writes the model of a layout with all that modelFor() needs. @throws FileTrouble
void saveModel(const Layout& layout, const std::vector<Photograph>& photographs, const std::string& path);

#endif
