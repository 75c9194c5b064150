// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#ifndef OPENCV_GCPW_IMAGE_GRAPH_HPP
#define OPENCV_GCPW_IMAGE_GRAPH_HPP

#include <vector>
#include <opencv2/core.hpp>

namespace cv
{
namespace gcpw
{

/// Two images that share canvas pixels.
struct Overlap
{
    int a = -1; ///< a < b
    int b = -1;
    int period_offset_b = 0; ///< times the canvas' period that b is seen to the right of its own place
    int area = 0;            ///< px inside both masks
};

/** @brief Every pair of images that overlap enough to be aligned to each other, in ascending order.
@param corners canvas position of each image  @param masks CV_8UC1, non-zero inside
@param period px after which the canvas repeats in x, not less than the width of any image; 0 if it does not. Two images may
then meet on both sides */
std::vector<Overlap> findOverlaps(const std::vector<Point>& corners, const std::vector<Mat>& masks, int period = 0);

/** @brief The overlaps that are worth comparing, in the same order.

Where many images show the same, some comparisons add nothing to the others. Overlaps are taken by falling area; one is
left out if in both its images at least half of it is shared with `enough` others that were taken.
@param enough 1 or more; images are never compared with fewer where they overlap with so many */
std::vector<Overlap> withoutRepetition(const std::vector<Overlap>& overlaps, const std::vector<Point>& corners,
                                       const std::vector<Mat>& masks, int period, int enough);

/// The image from which all others are reached over the fewest overlaps in all; of equals the one that overlaps most.
int mostCentral(int images, const std::vector<Overlap>& overlaps);

} // namespace gcpw
} // namespace cv

#endif
