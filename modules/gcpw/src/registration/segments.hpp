// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#ifndef OPENCV_GCPW_SEGMENTS_HPP
#define OPENCV_GCPW_SEGMENTS_HPP

#include <vector>
#include "geometry/matches.hpp"
#include "registration/prediction.hpp"

namespace cv
{
namespace gcpw
{

enum class SegmentDetector
{
    FAST, ///< ximgproc::FastLineDetector: few, long, quick
    LSD   ///< cv::LineSegmentDetector: hardly misses an edge that the eye sees as straight
};

/** @brief Straight edges of an image, longest first, all with the brighter side on the same hand.

A segment that leaves the mask is cut to its longest part inside, with the pixels beside it that say what kind of edge it is:
hidden pixels are made up, and the border of a mask is no edge of the scene.
@param gray CV_8UC1  @param mask CV_8UC1 of its size, segments only where non-zero; empty means everywhere
@param to_reference as for detectKeypoints()  @param min_length reference px */
std::vector<Segment> detectSegments(const Mat& gray, const Mat& mask, Size2d to_reference, double min_length,
                                    SegmentDetector detector = SegmentDetector::FAST);

/// How closely a segment must follow where it is expected to be taken for the target.
struct SegmentTolerance
{
    double distance = 4;  ///< px, RMS over the common part
    double angle = 0.1;   ///< radians
    double overlap = 0.5; ///< least common part, as a share of the shorter one
    double crossing = 20; ///< px: least length that b shows of a segment that crosses its border
};

/** @brief Pairs segments by where those of a are expected in b, best first, each used once.

Of a segment that crosses b's border only the part that b shows is compared, and matched.
The weight of a match is the share of the longer segment that both have in common. */
std::vector<LineMatch> matchSegments(const std::vector<Segment>& a, const std::vector<Segment>& b,
                                     const Prediction& b_from_a, const SegmentTolerance& tolerance);

} // namespace gcpw
} // namespace cv

#endif
