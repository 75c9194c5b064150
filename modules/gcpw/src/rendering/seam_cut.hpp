// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#ifndef OPENCV_GCPW_SEAM_CUT_HPP
#define OPENCV_GCPW_SEAM_CUT_HPP

#include "rendering/ghosts.hpp"

namespace cv
{
namespace gcpw
{

const double SEAM_MEGAPIX = 0.1; ///< of what cuts are found in, as cv::Stitcher has it: graph cut takes seconds at more

/** @brief How much a cut between two pictures shows at each pixel, gray levels.

    C = sqrt(G * (dY^2 + (dCr^2 + dCb^2) / 2 + |grad dY|^2))

d is the difference of the pictures and G a Gaussian of 2 px over the pixels that both have. Unlike the difference alone it is small
only where pictures agree *all around*: between the two pictures of a thing that they show in different places lie pixels that agree by
chance, and a cut that follows them leaves halves of the thing.
@param roi part of the canvas that lies in both pictures
@return CV_32FC1 of the size of roi; 0 where one of them has no pixel */
Mat seamCost(const PlacedPicture& first, const PlacedPicture& second, Rect roi);

/** @brief Splits what two pictures share: afterwards no pixel is in both masks.

Graph cut over seamCost(), and over the ways between the two places of each ghost: a cut that crosses one shows a thing twice, or not
at all, however little it shows where it runs.
@param ghosts of findGhosts()

Nothing happens if they do not overlap. */
void cutBetween(PlacedPicture& first, PlacedPicture& second, const std::vector<Ghost>& ghosts);

} // namespace gcpw
} // namespace cv

#endif
