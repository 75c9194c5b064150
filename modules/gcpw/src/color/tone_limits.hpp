// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#ifndef OPENCV_GCPW_TONE_LIMITS_HPP
#define OPENCV_GCPW_TONE_LIMITS_HPP

#include <algorithm>
#include <vector>
#include "color/photograph_tone.hpp"
#include "overlap/color_comparison.hpp"

namespace cv
{
namespace gcpw
{

/// Which images may be shifted, and in how many channels.
struct ToneGauge
{
    std::vector<bool> fixed; ///< keep their colours; so does the mean of all that they are connected with
    std::vector<bool> gray;  ///< keep their hue
    std::vector<int> group;  ///< images that are connected have the same number

    /// Whether an image is fixed, whose light the others take.
    bool hasReference() const { return std::find(fixed.begin(), fixed.end(), true) != fixed.end(); }
};

/** @brief Colours that keep the light of the photographs, the nearest to those given.

Afterwards no quad's hue is changed much more than that of its image, no pixel is crushed or blown (PhotographTone::needs()), and the
mean Y, Cr and Cb of connected images is that of their photographs unless one of them is fixed; if not all can be had, means give way.
What a quad needs fades over its neighbours and over the quads that it is compared with, so neither its edges nor cuts show.
@param comparisons the quads that show the same; may be empty */
void limitTones(const std::vector<PhotographTone>& tones, const std::vector<ColorComparison>& comparisons, const ToneGauge& gauge,
                std::vector<ColorGrid>& colors);

/// Of these only: no pixel of the image is crushed or blown.
void limitExtremes(const PhotographTone& tone, ColorGrid& colors);

} // namespace gcpw
} // namespace cv

#endif
