// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#include "stitching/warped_lines.hpp"

#include <cmath>
#include "geometry/curve.hpp"
#include "geometry/frame_scale.hpp"
#include "imaging/photograph.hpp"
#include "registration/straight_lines.hpp"

namespace cv
{
namespace gcpw
{

namespace
{

const double PIECE = 8; ///< px of a photograph from point to point: no projection bends so short a piece

typedef std::vector<std::vector<Point2f>> Curves;

/// @param pixel_of from the pixels of the segments to canvas px of the picture
template <typename Map>
Curves warped(const std::vector<Segment>& segments, Map pixel_of)
{
    Curves curves;
    for (const Segment& segment : segments)
    {
        std::vector<Point2f> curve;
        bool whole = true;
        for (const Point2d& p : resampled({segment.start, segment.end}, PIECE))
        {
            curve.push_back(pixel_of(p));
            whole = whole && std::isfinite(curve.back().x) && std::isfinite(curve.back().y);
        }
        if (whole && curve.size() > 1)
            curves.push_back(curve);
    }
    return curves;
}

} // namespace

KnownLines warpedLines(const Mat& image, cv::detail::RotationWarper& warper, const Mat& K, const Mat& R, Point corner,
                       double megapix)
{
    const Photograph photograph = toPhotograph(image, "warped");
    const FrameScale scale(cappedSize(image.size(), megapix), image.size());
    const Photograph small = resized(photograph, scale);
    const auto pixel_of = [&](Point2d p) { return warper.warpPoint(Point2f(scale.toFull(p)), K, R) - Point2f(corner); };
    KnownLines lines;
    lines.curves = warped(findStraightLines(small.image, small.mask), pixel_of);
    lines.borders = warped(bordersOf(small.image.size()), pixel_of);
    return lines;
}

} // namespace gcpw
} // namespace cv
