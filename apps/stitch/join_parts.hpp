// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#ifndef GCPW_APPS_STITCH_JOIN_PARTS_HPP
#define GCPW_APPS_STITCH_JOIN_PARTS_HPP

#include <string>
#include "common/console.hpp"
#include "stitch/job.hpp"

/// What a file says of itself that holds some rows of tiles of a picture.
std::string describePart(cv::Range tile_rows, cv::Size picture);

/** @brief Puts the files of --tiles together: the same file that one call without it writes, or a Deep Zoom pyramid.
@param job paths and output are used  @throws WrongUse if they are no such parts, not of one picture, or not all */
void joinParts(const StitchJob& job, const Console& console);

#endif
