// Part of the GCPW module for OpenCV. Licence: Apache-2.0 (see LICENSE).
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
