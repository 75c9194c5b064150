// Part of the GCPW module for OpenCV. Licence: Apache-2.0 (see LICENSE).
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

/** @brief What two photographs have in common: all that an alignment needs to know besides their pixels.

Found once by findPairMatches(), it serves any number of calls of alignPair(): other parameters, recoloured or filtered
copies of the photographs, the next frame of a rig. A caller with a matcher of his own may fill it in himself.
Positions are pixels of the photographs at full resolution, finite and at most 2^20. */
struct CV_EXPORTS PairMatches
{
    Status status = Status::OK; //!< OK, NO_ALIGNMENT or CANCELLED
    std::string message;        //!< empty, or why the status is not OK
    Size source_size;
    Size target_size;
    Matx33d target_from_source = Matx33d::eye(); //!< the rough homography; keeps the whole source upright, enlarged or reduced up to 1000 times

    std::vector<Point2d> source_points;
    std::vector<Point2d> target_points; //!< partner of each of source_points
    std::vector<Vec4d> source_lines;    //!< segments as x, y of the start, x, y of the end; they match as endless lines
    std::vector<Vec4d> target_lines;    //!< partner of each of source_lines
    std::vector<double> line_weights;   //!< > 0 and at most 1e9, one for each line; a point has weight 1

    Timings timings_ms; //!< features and homography only
};

/** @brief Finds the rough homography of two photographs, and keypoints and line segments that match, verified by a mesh.
@param source, target 8-bit BGR, gray or BGRA; 16-bit is scaled down. A 4th channel is the mask of valid pixels
@param params constants of mesh, resolution and matching; every method has the same matches
@param progress may be empty; cancelling returns Status::CANCELLED
@throws cv::Exception if an image is empty or of a type not listed, or params are out of range */
CV_EXPORTS PairMatches findPairMatches(InputArray source, InputArray target, const Params& params = Params(),
                                       const Progress& progress = Progress());

//! @}

} // namespace gcpw
} // namespace cv

#endif
