// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#ifndef GCPW_EVALUATION_BEFORE_AFTER_HPP
#define GCPW_EVALUATION_BEFORE_AFTER_HPP

#include <string>
#include <vector>
#include <opencv2/core.hpp>

namespace evaluation
{

/** @brief One picture of a panorama by cv::Stitcher alone, left, and with GCPW, right.

Above both panoramas at one scale, over them the straight segments of the photographs: green where they are held, red where they
bend by more than VISIBLE_BEND. Below, enlarged, the plain mean of the photographs, in which double edges show what does not line up: where the plain
panorama's cut breaks the strongest edges (framed blue), and where GCPW's does (framed orange), so that neither has chosen.
@param plain, gcpw folders with panorama.png or panorama.jpg, a dump (see readDump()), and for GCPW model.yml.gz
@param photographs those that were stitched, in the same order
@param width of the picture, px
@return CV_8UC3
@throws cv::Exception that names the file if one is missing or does not fit */
cv::Mat beforeAfter(const std::string& plain, const std::string& gcpw, const std::vector<std::string>& photographs, int width);

} // namespace evaluation

#endif
