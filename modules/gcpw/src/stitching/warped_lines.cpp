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

} // namespace

KnownLines warpedLines(const Mat& image, cv::detail::RotationWarper& warper, const Mat& K, const Mat& R, Point corner,
                       double megapix)
{
    const Photograph photograph = toPhotograph(image, "warped");
    const FrameScale scale(cappedSize(image.size(), megapix), image.size());
    const Photograph small = resized(photograph, scale);
    KnownLines lines;
    for (const Segment& line : findStraightLines(small.image, small.mask))
    {
        std::vector<Point2f> curve;
        bool whole = true;
        for (const Point2d& p : resampled({line.start, line.end}, PIECE))
        {
            const Point2f on_canvas = warper.warpPoint(Point2f(scale.toFull(p)), K, R) - Point2f(corner);
            whole = whole && std::isfinite(on_canvas.x) && std::isfinite(on_canvas.y);
            curve.push_back(on_canvas);
        }
        if (whole && curve.size() > 1)
            lines.curves.push_back(curve);
    }
    return lines;
}

} // namespace gcpw
} // namespace cv
