// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#ifndef OPENCV_GCPW_COLOR_AGREEMENT_HPP
#define OPENCV_GCPW_COLOR_AGREEMENT_HPP

#include <functional>
#include <vector>
#include "overlap/color_comparison.hpp"

namespace cv
{
namespace gcpw
{

/// The colour of a quad of an image, as it is assumed at present.
typedef std::function<const ColorGrid::Quad&(int image, int cell)> ColorOf;

/// How much two quads count.
struct QuadWeight
{
    double moments; ///< of QuadColors::moments
    double clipped; ///< of QuadColors::clipped
};

/// One for each quad of each comparison.
typedef std::vector<std::vector<QuadWeight>> QuadWeights;

/** @brief Which images have no colours: three equal channels.

Their Cr and Cb say nothing about the light, neither of theirs nor of others. */
std::vector<bool> grayImages(const std::vector<ColorComparison>& comparisons, size_t count);

/// Channels in which two images can be compared: 1 where either is gray, else all.
inline int comparableChannels(const ColorComparison& comparison, const std::vector<bool>& gray)
{
    return gray[comparison.source_image] || gray[comparison.target_image] ? 1 : CHANNELS;
}

/// likeness() of all quads.
QuadWeights likenessOf(const std::vector<ColorComparison>& comparisons);

/** @brief likeness() times the Geman-McClure weight of what two images differ by in their means, so that what only one of them
shows does not count.

Its scale is that of each overlap: `deviations` robust standard deviations (from the median), of at least 2 gray levels each. */
QuadWeights agreementOf(const std::vector<ColorComparison>& comparisons, const QuadWeights& likeness, const std::vector<bool>& gray,
                        const ColorOf& colors, double deviations);

} // namespace gcpw
} // namespace cv

#endif
