// Part of the GCPW module for OpenCV. Licence: Apache-2.0 (see LICENSE).
#ifndef OPENCV_GCPW_ALIGNER_CHECK_HPP
#define OPENCV_GCPW_ALIGNER_CHECK_HPP

#include "opencv2/gcpw/aligner.hpp"

namespace cv
{
namespace gcpw
{

/** @brief Refuses what Aligner::align() cannot work with: see there for the arguments.
@param sizes of the images, px as given
@throws cv::Exception that names the value and what it must be */
void checkAlignerInput(const std::vector<Point>& corners, const std::vector<Size>& sizes,
                       const std::vector<Correspondences>& correspondences,
                       const std::vector<KnownKeypoints>& keypoints, const Params& params);

} // namespace gcpw
} // namespace cv

#endif
