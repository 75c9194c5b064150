// Part of the GCPW module for OpenCV. Licence: Apache-2.0 (see LICENSE).
#ifndef OPENCV_GCPW_COLOR_REST_HPP
#define OPENCV_GCPW_COLOR_REST_HPP

#include <vector>
#include "color/color_comparison.hpp"
#include "energy/color_system.hpp"
#include "pipeline/problem.hpp"

namespace cv
{
namespace gcpw
{

/** @brief Where colours rest that nothing informs: E_r of eq. initialfunction, and a weak pull elsewhere.

Quads with samples are held weakly at their image's exposure: faint texture alone does not know its gain, and along a chain
contrast may drain away. Quads without samples rest at gain 1, bias 0 in a pair, as in the paper; of more images none has a
colour that all could be compared with, and they rest at their image's exposure too. */
class ColorRest
{
public:
    /// @param rest_weight of a quad without samples  @param exposure_weight of one with samples
    ColorRest(const Problem& problem, double rest_weight, double exposure_weight)
        : problem_(problem), rest_weight_(rest_weight), exposure_weight_(exposure_weight)
    {
    }

    /// Sets the pulls for the present meshes. The exposures are estimated once, at the first call.
    void pull(const std::vector<ColorComparison>& comparisons, ColorSystem& colors);

private:
    const Problem& problem_;
    double rest_weight_;
    double exposure_weight_;
    std::vector<ColorGrid::Quad> exposures_;
};

} // namespace gcpw
} // namespace cv

#endif
