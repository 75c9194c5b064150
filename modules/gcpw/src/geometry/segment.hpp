// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#ifndef OPENCV_GCPW_SEGMENT_HPP
#define OPENCV_GCPW_SEGMENT_HPP

#include <cmath>
#include <opencv2/core.hpp>

namespace cv
{
namespace gcpw
{

/// The line n . x + c = 0 with |n| = 1, so that its value at a point is the signed distance in pixels.
struct Line
{
    Point2d normal;
    double offset = 0;

    double distance(Point2d p) const { return normal.dot(p) + offset; }
};

/// A straight piece of an image edge, in pixels. Directed: detectSegments() has the brighter side on the left.
struct Segment
{
    Point2d start;
    Point2d end;

    Point2d direction() const { return end - start; }
    double length() const { return norm(end - start); }
    Point2d at(double t) const { return start + t * (end - start); }

    /// The infinite line through both ends; the ends must differ.
    Line line() const
    {
        const Point2d d = direction() / length();
        const Point2d n(-d.y, d.x);
        return {n, -n.dot(start)};
    }
};

} // namespace gcpw
} // namespace cv

#endif
