// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#ifndef GCPW_APPS_STITCH_STAND_UP_HPP
#define GCPW_APPS_STITCH_STAND_UP_HPP

#include <string>
#include <vector>
#include "common/read_photograph.hpp"

/** @brief How often a column's picture, which comes out turned to the left by 90 degrees, is turned to the right so that it stands.

Cameras store photographs lying and note the turn of those that were taken upright. A note that lays photographs on their side that
were stored upright is a stale one, as programs leave it that turn the pixels and forget the note: where such photographs stand in a
column, it is undone.
@param decisions gets a sentence if so  @return 0, 1 or 2 */
int turnsToStand(const Photograph& photograph, std::vector<std::string>& decisions);

/// A picture turned to the right by 90 degrees so often: 0, 1 or 2.
cv::Mat turned(const cv::Mat& picture, int turns);

#endif
