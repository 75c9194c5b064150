// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#ifndef OPENCV_GCPW_EXPOSURES_HPP
#define OPENCV_GCPW_EXPOSURES_HPP

#include <vector>
#include "overlap/color_comparison.hpp"

namespace cv
{
namespace gcpw
{

/** @brief One gain and bias per channel for each image as a whole, so that overlaps agree in mean and contrast.

Moments of whole overlaps hardly depend on how well they line up, so these are known before any pixel is aligned; quads
are weighted by how well they correlate (correlationWeight()). Of all that fit equally well the one of mean log gain 0 and mean
bias 0 is chosen; images that are fixed keep (1, 0) exactly, and so does a channel whose equations are singular. */
std::vector<ColorGrid::Quad> estimateExposures(const std::vector<ColorComparison>& comparisons, const std::vector<bool>& fixed);

/** @brief What part of its exposure each image as a whole is to show where none is the reference: a gain of Y that leaves black black,
and of Cr and Cb the same gain about gray and a shift.

Overlaps differ in their means mostly by the cameras' tone curves, which keep black and white; a bias that makes them agree would lift
shadows into haze, and a shift that makes hues agree would give to all what one camera took for white. So images go only a share
of the way to each other: 0.3 in the logarithm of the gain, 0.2 in hue. What remains is left to the overlaps.
@param count number of images */
std::vector<ColorGrid::Quad> sharedLights(const std::vector<ColorComparison>& comparisons, size_t count);

/** @brief The exposures that make all pixels agree, clipped ones too, where meshes are to be found by them.

Not re-weighted: while meshes move, what two images differ by is not yet what differs in the scene. */
std::vector<ColorGrid::Quad> exposuresOfAllPixels(const std::vector<ColorComparison>& comparisons, const std::vector<bool>& fixed);

} // namespace gcpw
} // namespace cv

#endif
