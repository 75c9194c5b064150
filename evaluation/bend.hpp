// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#ifndef GCPW_EVALUATION_BEND_HPP
#define GCPW_EVALUATION_BEND_HPP

#include <functional>
#include <vector>
#include <opencv2/gcpw/rig.hpp>

namespace evaluation
{

/// A bend that is seen, pixels of the mesh's resolution.
const double VISIBLE_BEND = 1.5;

/// What a mesh does to one straight segment of a photograph, beyond what its rough alignment does.
struct SegmentBend
{
    std::vector<cv::Point2d> path;       ///< where the mesh takes the segment, canvas, working pixels
    std::vector<cv::Point2d> rough_path; ///< where its rough alignment does
    double length = 0;             ///< pixels of the picture in which it was found
    double mean_square = 0;        ///< working pixels squared
    double largest = 0;            ///< working pixels
};

/// The same of all segments, working pixels. All 0 where nothing moves or no segment was found.
struct Bend
{
    int segments = 0;
    double rms = 0;   ///< weighted by the lengths of the segments
    double p95 = 0;   ///< of each segment's largest bend
    double share = 0; ///< per cent of the segments that bend by more than VISIBLE_BEND
    double largest = 0;
};

/// Straight segments of a photograph (x0, y0, x1, y1), of 6 % of its diagonal or more: shorter ones cannot be seen to bend.
/// @param photograph 8-bit, 1 or 3 channels  @param size to which it is scaled first
std::vector<cv::Vec4f> longSegments(const cv::Mat& photograph, cv::Size size);

/// Takes a pixel of the picture with the segments to the working pixels of the image that a mesh covers.
typedef std::function<cv::Point2d(cv::Point2d)> RestMap;

/** @brief How an image's mesh bends segments.

Along each segment the part of (mesh - rough) across the rough path is taken, less its best straight line: what only shifts or
turns a segment keeps it straight.
@param rest from the segments' picture to the image; empty if they are the same
@return one for each segment; those that leave the image, behind the seam of a full turn, are left out */
std::vector<SegmentBend> bendsOf(const cv::gcpw::AlignedImage& image, const std::vector<cv::Vec4f>& segments,
                                 const RestMap& rest = RestMap());

Bend summary(const std::vector<SegmentBend>& bends);

/// Whether a mesh is not its rough alignment; only images that move are measured.
bool moves(const cv::gcpw::AlignedImage& image);

/** @brief How a rig bends the segments of its photographs.
@param photographs those of the user, in the order of which rig.component counts; only those of images that move are asked for
@param still_too also looks for segments of images that do not move, to show them
@return for each image of the rig; none of those that do not move, unless wanted
@throws cv::Exception StsBadArg if none of OpenCV's warpers can have made the canvas of the rig */
std::vector<std::vector<SegmentBend>> bendsOf(const cv::gcpw::Rig& rig, const std::function<cv::Mat(int index)>& photographs,
                                              bool still_too = false);

} // namespace evaluation

#endif
