// Part of the GCPW module for OpenCV. Licence: Apache-2.0 (see LICENSE).
#ifndef OPENCV_GCPW_COLOR_PRIOR_HPP
#define OPENCV_GCPW_COLOR_PRIOR_HPP

#include <vector>
#include "energy/color_comparison.hpp"
#include "solver/color_system.hpp"

namespace cv
{
namespace gcpw
{

/// Where the colours of quads reference, one colour an image, and how prior_weights.
struct ColorPrior
{
    std::vector<double> weights;
    std::vector<ColorGrid::Quad> reference;
};

/// Replaces all priors of a colour system: `inside` for quads that are compared with others, `outside` for the reference.
void setColorPriors(const std::vector<ColorComparison>& comparisons, const std::vector<Lattice>& lattices, const ColorPrior& inside,
                const ColorPrior& outside, ColorSystem& colors);

} // namespace gcpw
} // namespace cv

#endif
