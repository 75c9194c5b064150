// Part of the GCPW module for OpenCV. Licence: Apache-2.0 (see LICENSE).
#ifndef OPENCV_GCPW_COLOR_REFERENCE_HPP
#define OPENCV_GCPW_COLOR_REFERENCE_HPP

#include <vector>
#include "energy/color_comparison.hpp"
#include "solver/color_system.hpp"
#include "energy/problem.hpp"

namespace cv
{
namespace gcpw
{

/** @brief Where colours reference that nothing informs: E_r of eq. initialfunction, and a weak prior elsewhere.

Quads with samples are fixed weakly at their image's exposure: faint texture alone does not know its gain, and along a chain
contrast may drain away. Quads without samples rest at gain 1, bias 0 in a pair, as in the paper; of more images none has a
colour that all could be compared with, and they rest at their image's exposure too. */
class ColorReference
{
public:
    /// @param outside_weight of a quad without samples  @param exposure_weight of one with samples
    ColorReference(const Problem& problem, double outside_weight, double exposure_weight)
        : problem_(problem), outside_weight_(outside_weight), exposure_weight_(exposure_weight)
    {
    }

    /// Sets the priors for the present meshes. The exposures are estimated once, at the first call.
    void prior(const std::vector<ColorComparison>& comparisons, ColorSystem& colors);

private:
    const Problem& problem_;
    double outside_weight_;
    double exposure_weight_;
    std::vector<ColorGrid::Quad> exposures_;
};

} // namespace gcpw
} // namespace cv

#endif
