// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#include "rendering/remap_tiled.hpp"

#include <algorithm>
#include <opencv2/imgproc.hpp>

namespace cv
{
namespace gcpw
{

namespace
{

const int TILE = 1024; ///< rows a remap call

} // namespace

void remapTiled(const Mat& image, Mat& picture, const Mat& map1, const Mat& map2, int interpolation, int border_mode)
{
    Mat source = image; // its own reference: `picture` may be the same object
    picture.create(map1.size(), image.type());
    // One tile must not overwrite what the next one reads.
    if (source.datastart < picture.dataend && picture.datastart < source.dataend)
        source = source.clone();
    for (int top = 0; top < picture.rows; top += TILE)
    {
        const Range rows(top, std::min(top + TILE, picture.rows));
        Mat part = picture.rowRange(rows);
        remap(source, part, map1.rowRange(rows), map2.empty() ? Mat() : map2.rowRange(rows), interpolation, border_mode);
    }
}

} // namespace gcpw
} // namespace cv
