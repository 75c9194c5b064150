// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#ifndef OPENCV_GCPW_FEATHER_HPP
#define OPENCV_GCPW_FEATHER_HPP

#include <vector>
#include <opencv2/core.hpp>

namespace cv
{
namespace gcpw
{

/// What a picture on a canvas may show, and what a cut leaves to it.
struct CutPicture
{
    Mat valid; ///< CV_8UC1: where it has pixels
    Mat kept;  ///< CV_8UC1 of any size, that is stretched over it: what it is to show
    Point corner;
};

/** @brief Weights of pictures on a canvas, out of cuts at a lower resolution.

Every pixel that a picture has goes to the one that keeps most of it; across the cuts the weights fall off over a distance.
@param canvas that holds all of them
@param radius of the fall, px
@return for each picture CV_8UC1 of its size. They sum to 255 at every pixel that a picture has, and are 0 where it has none */
std::vector<Mat> featherWeights(const std::vector<CutPicture>& pictures, Rect canvas, int radius);

} // namespace gcpw
} // namespace cv

#endif
