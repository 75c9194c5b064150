// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#include "imaging/pyramid.hpp"

#include <opencv2/imgproc.hpp>

namespace cv
{
namespace gcpw
{

namespace
{

const int MIN_LEVEL_SIDE = 16; ///< px; below, three samples a side are left, too few to align

/// YCrCb in [0, 1] plus the mask, as one CV_32FC4 image.
Mat packed(const Mat& image, const Mat& mask)
{
    Mat ycrcb;
    cvtColor(image, ycrcb, COLOR_BGR2YCrCb);
    const Mat inside = mask.empty() ? Mat(image.size(), CV_8U, Scalar(255)) : Mat(mask != 0);
    Mat bytes(image.size(), CV_8UC4);
    const Mat sources[] = {ycrcb, inside};
    const int order[] = {0, 0, 1, 1, 2, 2, 3, 3};
    mixChannels(sources, 2, &bytes, 1, order, 4);
    Mat pixels;
    bytes.convertTo(pixels, CV_32F, 1.0 / 255.0);
    return pixels;
}

} // namespace

std::vector<PyramidLevel> buildPyramid(const Mat& image, const Mat& mask, int levels)
{
    CV_CheckTypeEQ(image.type(), CV_8UC3, "A pyramid is built of 8-bit BGR images");
    CV_CheckGT(levels, 0, "A pyramid has at least one level");
    CV_Assert(mask.empty() || (mask.type() == CV_8UC1 && mask.size() == image.size()));
    std::vector<PyramidLevel> pyramid(1);
    pyramid[0].pixels = packed(image, mask);
    while (static_cast<int>(pyramid.size()) < levels)
    {
        const PyramidLevel& fine = pyramid.back();
        if (std::min(fine.pixels.cols, fine.pixels.rows) < 2 * MIN_LEVEL_SIDE)
            break;
        PyramidLevel coarse;
        pyrDown(fine.pixels, coarse.pixels);
        coarse.scale = 2 * fine.scale;
        pyramid.push_back(coarse);
    }
    return pyramid;
}

} // namespace gcpw
} // namespace cv
