// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#include "api/rough_start.hpp"

#include <algorithm>
#include "registration/image_graph.hpp"

namespace cv
{
namespace gcpw
{

namespace
{

const int COMPARISONS = 3;   ///< of a pixel with other images: more of them add little
const int NO_REFERENCE = -2; ///< Params::referenceImage: all images move

std::vector<Overlap> overlapsOf(const std::vector<WorkImage>& images, const std::vector<Point2d>& corners,
                                double period)
{
    std::vector<Point> pixels;
    std::vector<Mat> masks;
    for (size_t i = 0; i < images.size(); ++i)
    {
        pixels.emplace_back(cvRound(corners[i].x), cvRound(corners[i].y));
        const Photograph& photograph = images[i].photograph;
        masks.push_back(photograph.mask.empty() ? Mat(photograph.image.size(), CV_8U, Scalar(255)) : photograph.mask);
    }
    return withoutRepetition(findOverlaps(pixels, masks, cvRound(period)), pixels, masks, cvRound(period), COMPARISONS);
}

ProblemPair toPair(const Overlap& overlap, double period, int fixed)
{
    ProblemPair pair;
    pair.a = overlap.a;
    pair.b = overlap.b;
    pair.shift_b = Point2d(overlap.period_offset_b * period, 0);
    if (pair.a == fixed)
    {
        std::swap(pair.a, pair.b); // samples lie in an image that moves
        pair.shift_b = -pair.shift_b;
    }
    return pair;
}

} // namespace

RoughStart startOfPair(const Matx33d& target_from_source)
{
    RoughStart start;
    start.canvas_from_image = {target_from_source, Matx33d::eye()};
    start.pairs.resize(1);
    start.pairs[0].a = 0;
    start.pairs[0].b = 1;
    start.fixed = start.color_reference = 1;
    return start;
}

RoughStart startOnCanvas(const std::vector<WorkImage>& images, const std::vector<Point>& corners, const Params& params)
{
    const FrameScale scale = images.front().scale;
    // As seen from the reference image if one is named: where the caller's canvas has its origin must not matter.
    const Point origin = corners[std::max(params.referenceImage, 0)];
    RoughStart start;
    start.origin = Point2d(origin.x * scale.x, origin.y * scale.y);
    std::vector<Point2d> moved;
    for (const Point& corner : corners)
    {
        // canvas_work = (corner + (reference + 0.5) / scale) * scale - 0.5
        const Point from_origin = corner - origin;
        moved.emplace_back(from_origin.x * scale.x, from_origin.y * scale.y);
        start.canvas_from_image.emplace_back(1, 0, moved.back().x, 0, 1, moved.back().y, 0, 0, 1);
    }
    const double period = params.canvasPeriod * scale.x;
    const std::vector<Overlap> overlaps = overlapsOf(images, moved, period);
    if (params.referenceImage != NO_REFERENCE)
        start.fixed =
            params.referenceImage >= 0 ? params.referenceImage : mostCentral(static_cast<int>(images.size()), overlaps);
    start.color_reference = std::max(params.referenceImage, -1);
    for (const Overlap& overlap : overlaps)
        start.pairs.push_back(toPair(overlap, period, start.fixed));
    return start;
}

} // namespace gcpw
} // namespace cv
