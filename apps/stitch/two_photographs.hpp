// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#ifndef GCPW_APPS_STITCH_TWO_PHOTOGRAPHS_HPP
#define GCPW_APPS_STITCH_TWO_PHOTOGRAPHS_HPP

#include "stitch/compose.hpp"

/** @brief Stitches two photographs that no cameras were found for as gcpw_pair does, which asks for a homography only.
@param layout gets both photographs and the decision if that succeeds
@return whether it did */
bool stitchTwo(const StitchJob& job, const std::vector<Photograph>& photographs, Layout& layout,
               Composition& composition);

#endif
