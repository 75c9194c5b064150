// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#ifndef OPENCV_GCPW_ESTIMATE_COLORS_HPP
#define OPENCV_GCPW_ESTIMATE_COLORS_HPP

#include <vector>
#include "opencv2/gcpw/params.hpp"

namespace cv
{
namespace gcpw
{

/** @brief The colours that fit best while the images stand still where they are: balancedColors().

@param corners canvas position of each image  @param images CV_8UC3 or CV_8UC1  @param masks CV_8UC1, non-zero inside
@return one meshRows x meshCols, CV_32FC(6) per image, as in Alignment::Image */
std::vector<Mat> estimateColors(const std::vector<Point>& corners, const std::vector<Mat>& images,
                                const std::vector<Mat>& masks, const Params& params);

} // namespace gcpw
} // namespace cv

#endif
