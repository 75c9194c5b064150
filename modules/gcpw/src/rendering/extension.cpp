// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#include "rendering/extension.hpp"

#include <algorithm>
#include <opencv2/imgproc.hpp>

namespace cv
{
namespace gcpw
{

namespace
{

const int BAND = 128; ///< coarse rows that are made at once
const int COARSE = 4; ///< px a side that get one colour outside: no difference in coarse bands, in a quarter of the time

/// Push: colours times coverage, and coverage, at half the size. Pull: where nothing is covered, the coarser colours.
Mat filled(const Mat& covered_colors, const Mat& coverage)
{
    const Size size = coverage.size();
    Mat coverage_of_all;
    merge(std::vector<Mat>(covered_colors.channels(), coverage), coverage_of_all);
    Mat colors;
    divide(covered_colors, coverage_of_all, colors);
    const Mat outside = coverage <= 0;
    if (coverage.total() == 1 || countNonZero(outside) == 0)
        return colors;
    const Size half((size.width + 1) / 2, (size.height + 1) / 2);
    Mat half_colors;
    Mat half_coverage;
    resize(covered_colors, half_colors, half, 0, 0, INTER_AREA);
    resize(coverage, half_coverage, half, 0, 0, INTER_AREA);
    Mat coarser;
    resize(filled(half_colors, half_coverage), coarser, size, 0, 0, INTER_LINEAR);
    coarser.copyTo(colors, outside);
    return colors;
}

} // namespace

void extendOutside(Mat& image, const Mat& mask)
{
    CV_Assert(mask.type() == CV_8UC1 && mask.size() == image.size());
    const Mat outside = mask == 0;
    const int count = countNonZero(outside);
    if (count == 0 || static_cast<size_t>(count) == mask.total())
        return;
    image.setTo(Scalar::all(0), outside);
    const Size coarse((image.cols + COARSE - 1) / COARSE, (image.rows + COARSE - 1) / COARSE);
    Mat covered_colors(coarse, CV_32FC(image.channels()));
    Mat coverage(coarse, CV_32F);
    // In bands of rows: floats of a whole picture are twelve bytes a pixel.
    Mat wide;
    for (int top = 0; top < coarse.height; top += BAND)
    {
        const int bottom = std::min(top + BAND, coarse.height);
        const Range rows(top * COARSE, std::min(bottom * COARSE, image.rows));
        const Size size(coarse.width, bottom - top);
        image.rowRange(rows).convertTo(wide, CV_32F);
        Mat colors = covered_colors.rowRange(top, bottom);
        resize(wide, colors, size, 0, 0, INTER_AREA);
        Mat(outside.rowRange(rows) == 0).convertTo(wide, CV_32F, 1 / 255.0);
        Mat share = coverage.rowRange(top, bottom);
        resize(wide, share, size, 0, 0, INTER_AREA);
    }
    wide.release();
    Mat result;
    filled(covered_colors, coverage).convertTo(result, image.depth());
    resize(result, result, image.size(), 0, 0, INTER_LINEAR);
    result.copyTo(image, outside);
}

} // namespace gcpw
} // namespace cv
