// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#ifndef OPENCV_GCPW_GHOSTS_HPP
#define OPENCV_GCPW_GHOSTS_HPP

#include <vector>
#include "rendering/placed_picture.hpp"

namespace cv
{
namespace gcpw
{

/** @brief A thing that two pictures show at different places of the canvas, px.

It stands twice in a panorama that takes its place in the first picture from the first and that in the second from the second, and
nowhere in one that does the opposite. */
struct Ghost
{
    Point in_first;
    Point in_second;
};

/** @brief Finds things that two aligned pictures show at different places.

Patches of 9 px that have texture and do not agree with what the other picture has there are searched around it by normalised
correlation, so that light does not matter. Kept are those found at one place only, that lead back, and whose neighbours move
alike. A patch with an edge alone is found across the edge.
@return the same list for any number of threads */
std::vector<Ghost> findGhosts(const PlacedPicture& first, const PlacedPicture& second);

} // namespace gcpw
} // namespace cv

#endif
