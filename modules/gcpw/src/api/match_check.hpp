// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#ifndef OPENCV_GCPW_MATCH_CHECK_HPP
#define OPENCV_GCPW_MATCH_CHECK_HPP

#include "opencv2/gcpw/pair_matches.hpp"

namespace cv
{
namespace gcpw
{

/** @brief Refuses matches that no pair of photographs of these sizes can have.
@throws cv::Exception that names the member, its value and what it must be */
void checkMatches(const PairMatches& matches, Size source, Size target);

} // namespace gcpw
} // namespace cv

#endif
