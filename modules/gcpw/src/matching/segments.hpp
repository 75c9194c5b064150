// Part of the GCPW module for OpenCV. Licence: Apache-2.0 (see LICENSE).
#ifndef OPENCV_GCPW_SEGMENTS_HPP
#define OPENCV_GCPW_SEGMENTS_HPP

#include <functional>
#include <vector>
#include "geometry/matches.hpp"

namespace cv
{
namespace gcpw
{

/** @brief Straight edges of an image, longest first, all with the brighter side on the same hand.
@param gray CV_8UC1  @param to_rest as for detectKeypoints()  @param min_length rest px */
std::vector<Segment> detectSegments(const Mat& gray, Size2d to_rest, double min_length);

/// How closely a segment must follow where it is expected to be taken for the partner.
struct SegmentTolerance
{
    double distance = 4;   ///< px, RMS over the common part
    double angle = 0.1;    ///< radians
    double overlap = 0.5;  ///< least common part, as a share of the shorter one
};

/** @brief Pairs segments by where those of a are expected in b, best first, each used once.
@param b_from_a where a point of a is expected in b's rest pixels
The weight of a match is the share of the longer segment that both have in common. */
std::vector<LineMatch> matchSegments(const std::vector<Segment>& a, const std::vector<Segment>& b,
                                     const std::function<Point2d(Point2d)>& b_from_a, const SegmentTolerance& tolerance);

} // namespace gcpw
} // namespace cv

#endif
