// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#ifndef OPENCV_GCPW_PLACED_PICTURE_HPP
#define OPENCV_GCPW_PLACED_PICTURE_HPP

#include <opencv2/core.hpp>

namespace cv
{
namespace gcpw
{

/// A picture at its place on a canvas.
struct PlacedPicture
{
    Mat image; ///< CV_32FC3, BGR in 0..255
    Mat mask;  ///< CV_8UC1, non-zero inside
    Point corner;

    Rect rect() const { return {corner, image.size()}; }
};

} // namespace gcpw
} // namespace cv

#endif
