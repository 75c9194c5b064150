// Part of the GCPW module for OpenCV. Licence: Apache-2.0 (see LICENSE).
#ifndef OPENCV_GCPW_COLOR_PULL_HPP
#define OPENCV_GCPW_COLOR_PULL_HPP

#include <vector>
#include "color/color_comparison.hpp"
#include "energy/color_system.hpp"

namespace cv
{
namespace gcpw
{

/// Where the colours of quads rest, one colour an image, and how firmly.
struct ColorPull
{
    std::vector<double> weights;
    std::vector<ColorGrid::Quad> rest;
};

/// Replaces all pulls of a colour system: `inside` for quads that are compared with others, `outside` for the rest.
void pullColors(const std::vector<ColorComparison>& comparisons, const std::vector<Lattice>& lattices, const ColorPull& inside,
                const ColorPull& outside, ColorSystem& colors);

} // namespace gcpw
} // namespace cv

#endif
