// Part of the GCPW module for OpenCV. Licence: Apache-2.0 (see LICENSE).
#ifndef OPENCV_GCPW_COLOR_REST_HPP
#define OPENCV_GCPW_COLOR_REST_HPP

#include <vector>
#include "energy/color_system.hpp"
#include "pipeline/color_comparison.hpp"
#include "pipeline/problem.hpp"

namespace cv
{
namespace gcpw
{

/** @brief One gain and bias per channel for each image as a whole, so that overlaps agree in mean and contrast.

Moments of whole overlaps hardly depend on how well they line up, so these are known before any pixel is aligned; quads
count as far as they show the same thing (trustIn()). Of all that fit equally well the one of mean log gain 0 and mean bias 0 is chosen; images that are held keep (1, 0). */
std::vector<ColorGrid::Quad> estimateExposures(const std::vector<ColorComparison>& comparisons,
                                               const std::vector<bool>& held);

/// Where the colours of quads rest, one colour an image, and how firmly.
struct ColorPull
{
    std::vector<double> weights;
    std::vector<ColorGrid::Quad> rest;
};

/// Replaces all pulls of a colour system: `inside` for quads that are compared with others, `outside` for the rest.
void pullColors(const std::vector<ColorComparison>& comparisons, const std::vector<Lattice>& lattices, const ColorPull& inside,
                const ColorPull& outside, ColorSystem& colors);

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
