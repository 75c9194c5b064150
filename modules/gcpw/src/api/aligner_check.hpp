// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#ifndef OPENCV_GCPW_ALIGNER_CHECK_HPP
#define OPENCV_GCPW_ALIGNER_CHECK_HPP

#include "opencv2/gcpw/aligner.hpp"

namespace cv
{
namespace gcpw
{

/** @brief Refuses what Aligner::align() cannot work with: see there for the arguments.
@throws cv::Exception that names the value and what it must be */
void checkAlignerInput(const std::vector<Point>& corners, const std::vector<Mat>& images, const std::vector<Mat>& masks,
                       const std::vector<Correspondences>& correspondences,
                       const std::vector<KnownKeypoints>& keypoints, const std::vector<KnownLines>& lines,
                       const Params& params);

} // namespace gcpw
} // namespace cv

#endif
