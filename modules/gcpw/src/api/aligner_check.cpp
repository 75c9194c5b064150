// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#include "api/aligner_check.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include "api/work_image.hpp"

namespace cv
{
namespace gcpw
{

namespace
{

const double MAX_CANVAS =
    1 << 20;                   ///< px a side: farther apart, positions lose the precision that the alignment works at
const double PERIOD_SLACK = 1; ///< px: an image all around may end in the very column it began with

void checkImages(const std::vector<Mat>& images, const std::vector<Mat>& masks, size_t corners)
{
    CV_CheckGE(images.size(), size_t(2), "gcpw: Aligner::align() takes two images or more");
    CV_CheckEQ(images.size(), corners, "gcpw: Aligner::align() takes one corner for each image");
    if (!masks.empty())
        CV_CheckEQ(images.size(), masks.size(), "gcpw: Aligner::align() takes one mask for each image, or none");
    for (size_t i = 0; i < images.size(); ++i)
    {
        checkPhotograph(images[i], format("%zu-th", i).c_str());
        if (masks.empty() || masks[i].empty())
            continue;
        CV_CheckTypeEQ(masks[i].type(), CV_8UC1, "gcpw: a mask is 8-bit with one channel");
        if (masks[i].dims > 2 || masks[i].size() != images[i].size())
            CV_Error(Error::StsUnmatchedSizes, format("gcpw: mask %zu is not of its image's size", i));
    }
}

void checkWorkingSizes(const std::vector<Size>& sizes, double work_megapix)
{
    const double scale = frameScales(sizes, work_megapix, ScaleRule::COMMON).front().x;
    for (size_t i = 0; i < sizes.size(); ++i)
        if (cvRound(sizes[i].width * scale) < 1 || cvRound(sizes[i].height * scale) < 1)
            CV_Error(Error::StsOutOfRange,
                     format("gcpw: image %zu of %d x %d px vanishes at the working resolution; raise "
                            "Params::workMegapix, which is %g",
                            i, sizes[i].width, sizes[i].height, work_megapix));
}

void checkCorners(const std::vector<Point>& corners, const std::vector<Size>& sizes)
{
    const double endless = std::numeric_limits<double>::infinity();
    Point2d low(endless, endless);
    Point2d high(-endless, -endless);
    for (size_t i = 0; i < corners.size(); ++i)
    {
        const Point2d corner = corners[i];
        low = Point2d(std::min(low.x, corner.x), std::min(low.y, corner.y));
        high = Point2d(std::max(high.x, corner.x + sizes[i].width), std::max(high.y, corner.y + sizes[i].height));
    }
    if (high.x - low.x > MAX_CANVAS || high.y - low.y > MAX_CANVAS)
        CV_Error(Error::StsOutOfRange,
                 format("gcpw: the corners make a canvas of %.0f x %.0f px; more than %.0f px a side are not aligned",
                        high.x - low.x, high.y - low.y, MAX_CANVAS));
}

void checkPeriod(double period, const std::vector<Size>& sizes)
{
    for (size_t i = 0; i < sizes.size(); ++i)
        if (period > 0 && sizes[i].width > period + PERIOD_SLACK)
            CV_Error(Error::StsOutOfRange, format("gcpw: Params::canvasPeriod is %g px but image %zu is %d px wide; "
                                                  "the canvas cannot repeat inside an image",
                                                  period, i, sizes[i].width));
}

void checkFinite(const std::vector<Point2f>& points, const std::string& name)
{
    for (size_t i = 0; i < points.size(); ++i)
        if (!std::isfinite(points[i].x) || !std::isfinite(points[i].y))
            CV_Error(Error::StsOutOfRange,
                     format("gcpw: %s[%zu] is (%g, %g); it must be finite", name.c_str(), i, points[i].x, points[i].y));
}

void checkCorrespondences(const std::vector<Correspondences>& correspondences, int images)
{
    for (size_t k = 0; k < correspondences.size(); ++k)
    {
        const Correspondences& item = correspondences[k];
        const std::string name = format("correspondences[%zu]", k);
        for (const int image : {item.a, item.b})
            if (image < 0 || image >= images)
                CV_Error(Error::StsOutOfRange,
                         format("gcpw: %s name image %d; there are images 0 to %d", name.c_str(), image, images - 1));
        if (item.a == item.b)
            CV_Error(Error::StsBadArg,
                     format("gcpw: %s are of image %d and itself; name two images", name.c_str(), item.a));
        CV_CheckEQ(item.points_a.size(), item.points_b.size(), "gcpw: correspondences come in pairs of points");
        checkFinite(item.points_a, name + ".points_a");
        checkFinite(item.points_b, name + ".points_b");
    }
}

void checkKeypoints(const std::vector<KnownKeypoints>& keypoints, int images)
{
    if (!keypoints.empty())
        CV_CheckEQ(static_cast<int>(keypoints.size()), images,
                   "gcpw: Aligner::align() takes keypoints for each image, or none");
    for (size_t i = 0; i < keypoints.size(); ++i)
    {
        const KnownKeypoints& item = keypoints[i];
        CV_CheckEQ(static_cast<int>(item.points.size()), item.descriptors.rows,
                   "gcpw: one descriptor for each keypoint");
        if (item.points.empty())
            continue;
        if (item.descriptors.cols != 128 || item.descriptors.channels() != 1 ||
            (item.descriptors.depth() != CV_32F && item.descriptors.depth() != CV_8U))
            CV_Error(Error::StsBadArg, "gcpw: descriptors are SIFT's: 128 columns of CV_32F or CV_8U");
        if (!checkRange(item.descriptors))
            CV_Error(Error::StsOutOfRange,
                     format("gcpw: keypoints[%zu].descriptors hold values that are not finite", i));
        checkFinite(item.points, format("keypoints[%zu].points", i));
    }
}

void checkCurves(const std::vector<std::vector<Point2f>>& curves, const std::string& name)
{
    for (size_t k = 0; k < curves.size(); ++k)
    {
        CV_CheckGE(curves[k].size(), size_t(2), "gcpw: a curve has two points or more");
        checkFinite(curves[k], format("%s[%zu]", name.c_str(), k));
    }
}

void checkLines(const std::vector<KnownLines>& lines, int images)
{
    if (!lines.empty())
        CV_CheckEQ(static_cast<int>(lines.size()), images, "gcpw: Aligner::align() takes lines for each image, or none");
    for (size_t i = 0; i < lines.size(); ++i)
    {
        checkCurves(lines[i].curves, format("lines[%zu].curves", i));
        checkCurves(lines[i].borders, format("lines[%zu].borders", i));
    }
}

} // namespace

void checkAlignerInput(const std::vector<Point>& corners, const std::vector<Mat>& images, const std::vector<Mat>& masks,
                       const std::vector<Correspondences>& correspondences,
                       const std::vector<KnownKeypoints>& keypoints, const std::vector<KnownLines>& lines,
                       const Params& params)
{
    checkImages(images, masks, corners.size());
    std::vector<Size> sizes;
    for (const Mat& image : images)
        sizes.push_back(image.size());
    const int count = static_cast<int>(images.size());
    CV_CheckLT(params.referenceImage, count, "gcpw: Params::referenceImage is not one of the images");
    checkWorkingSizes(sizes, params.workMegapix);
    checkCorners(corners, sizes);
    checkPeriod(params.canvasPeriod, sizes);
    checkCorrespondences(correspondences, count);
    checkKeypoints(keypoints, count);
    checkLines(lines, count);
}

} // namespace gcpw
} // namespace cv
