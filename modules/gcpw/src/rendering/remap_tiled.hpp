// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#ifndef OPENCV_GCPW_REMAP_TILED_HPP
#define OPENCV_GCPW_REMAP_TILED_HPP

#include <opencv2/core.hpp>

namespace cv
{
namespace gcpw
{

const int MAX_REMAP_SIDE = 32766; ///< px: cv::remap takes no more

/** @brief cv::remap in tiles of rows: the same picture, but its temporaries are bounded by a tile, not by the picture.
@param image what is read
@param picture receives the map's size and the image's type; kept if it has them already. It may be the image itself or
share memory with it
@param map1, map2 as of cv::remap; map2 is empty if map1 has both coordinates
@param interpolation, border_mode as of cv::remap */
void remapTiled(const Mat& image, Mat& picture, const Mat& map1, const Mat& map2, int interpolation, int border_mode);

} // namespace gcpw
} // namespace cv

#endif
