// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#ifndef OPENCV_GCPW_ROUGH_START_HPP
#define OPENCV_GCPW_ROUGH_START_HPP

#include <vector>
#include "api/work_image.hpp"
#include "energy/problem.hpp"
#include "opencv2/gcpw/params.hpp"

namespace cv
{
namespace gcpw
{

/** @brief Where the rough alignment has the images, and which of them are compared.

Besides ScaleRule it is all in which two photographs and images on a canvas differ. Working pixels throughout. */
struct RoughStart
{
    std::vector<Matx33d> canvas_from_image; ///< homography of each image
    std::vector<ProblemPair> pairs;         ///< without matches
    int fixed = -1;                         ///< the image that keeps its place; -1: none
    int color_reference = -1;               ///< the image that keeps its colours; -1: none
    Point2d origin;                         ///< of this canvas on the caller's
};

/// Two photographs on the canvas of the second, which is fixed.
RoughStart startOfPair(const Matx33d& target_from_source);

/** @brief Images that lie on a canvas already, and every two of them that overlap.
@param images scaled by ScaleRule::COMMON  @param corners top-left pixel of each image on the canvas, px as given */
RoughStart startOnCanvas(const std::vector<WorkImage>& images, const std::vector<Point>& corners, const Params& params);

} // namespace gcpw
} // namespace cv

#endif
