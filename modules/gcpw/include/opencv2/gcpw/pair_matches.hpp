// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#ifndef OPENCV_GCPW_PAIR_MATCHES_HPP
#define OPENCV_GCPW_PAIR_MATCHES_HPP

#include <string>
#include <vector>
#include "opencv2/gcpw/alignment.hpp"

namespace cv
{
namespace gcpw
{

//! @addtogroup gcpw
//! @{

/** @brief The matches of two photographs: all that an alignment needs to know besides their pixels.

Found once by findPairMatches(), it serves any number of calls of alignPair(): other parameters, recoloured or filtered
copies of the photographs, the next frame of a rig. It may also be filled in from the results of any other matcher.
Positions are pixels of the photographs at full resolution, finite and at most 2^20.

@code
const cv::gcpw::PairMatches matches = cv::gcpw::findPairMatches(source, target);
cv::gcpw::Params params;
for (double weight : {0.1, 0.2, 0.5})
{
    params.similarityWeight = weight;
    show(cv::gcpw::alignPair(source, target, matches, params));
}
@endcode */
struct CV_EXPORTS_W_SIMPLE PairMatches
{
    /// Status::OK without sizes and matches: to be filled in.
    CV_WRAP PairMatches() : status(Status::OK), target_from_source(Matx33d::eye()) {}

    CV_PROP_RW Status status; //!< OK, NO_ALIGNMENT or CANCELLED
    CV_PROP_RW std::string message; //!< empty, or why the status is not OK
    CV_PROP_RW Size source_size; //!< pixels of the source
    CV_PROP_RW Size target_size; //!< pixels of the target
    /// The rough homography, pixels to pixels; does not mirror the source, and enlarges or reduces every part of it up to 1000
    /// times.
    CV_PROP_RW Matx33d target_from_source;

    CV_PROP_RW std::vector<Point2d> source_points; //!< may be empty
    CV_PROP_RW std::vector<Point2d> target_points; //!< the match of each of source_points
    CV_PROP_RW std::vector<Vec4d> source_lines;    //!< segments as x, y of the start, x, y of the end; they match as infinite lines
    CV_PROP_RW std::vector<Vec4d> target_lines;    //!< the match of each of source_lines
    CV_PROP_RW std::vector<double> line_weights;   //!< > 0 and at most 1e9, one for each line; a point has weight 1

    CV_PROP_RW Timings timings_ms; //!< of features and homography only
};

/** @brief Finds the rough homography of two photographs, and keypoints and line segments that match, verified by a mesh.
@param source, target 8-bit BGR, gray or BGRA; 16-bit is scaled down. A 4th channel is the mask of valid pixels
@param params mesh, resolution and matching; the method is ignored: the matches serve all of them
@param progress may be empty; cancelling returns Status::CANCELLED
@return Status::OK with matches, or the reason why there are none
@throws cv::Exception if an image is empty or of a type not listed, or params are out of range */
CV_EXPORTS_W PairMatches findPairMatches(InputArray source, InputArray target, const Params& params = Params(),
                                         const Progress& progress = Progress());

//! @}

} // namespace gcpw
} // namespace cv

#endif
