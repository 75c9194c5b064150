// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#ifndef OPENCV_GCPW_MATCHES_HPP
#define OPENCV_GCPW_MATCHES_HPP

#include <vector>
#include "geometry/segment.hpp"

namespace cv
{
namespace gcpw
{

/// A point of image `a` and the same scene point in image `b`, each in the reference pixels of its own image.
struct PointMatch
{
    Point2d a;
    Point2d b;
    double weight = 1; ///< relative, > 0
};

/// A line segment of image `a` and its target in image `b`, each in the reference pixels of its own image.
struct LineMatch
{
    Segment a;
    Segment b;
    double weight = 1; ///< relative, > 0
};

/// All that is known to correspond between two images.
struct MatchSet
{
    std::vector<PointMatch> points;
    std::vector<LineMatch> lines;
};

} // namespace gcpw
} // namespace cv

#endif
