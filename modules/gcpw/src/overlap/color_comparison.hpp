// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#ifndef OPENCV_GCPW_COLOR_COMPARISON_HPP
#define OPENCV_GCPW_COLOR_COMPARISON_HPP

#include <vector>
#include "overlap/color_moments.hpp"
#include "overlap/overlap_samples.hpp"

namespace cv
{
namespace gcpw
{

/// What two images show where a quad of the source lies on a quad of the target, before any correction.
struct QuadColors
{
    int source_cell = -1;
    int target_cell = -1;
    ColorMoments moments; ///< of pixels that are clipped (isClipped()) in neither image; may be none
    ColorMoments clipped; ///< of pixels that are clipped in either; may be none
};

/// The colours of an overlap, in the order of the source's quads.
struct ColorComparison
{
    int source_image = -1;
    int target_image = -1;
    std::vector<QuadColors> quads;
};

ColorComparison compareColors(const OverlapSamples& samples, const State& state);

/// One for each overlap; runs on several threads.
std::vector<ColorComparison> compareColors(const std::vector<OverlapSamples>& overlaps, const State& state);

} // namespace gcpw
} // namespace cv

#endif
