// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#ifndef OPENCV_GCPW_COLOR_PRIOR_TERM_HPP
#define OPENCV_GCPW_COLOR_PRIOR_TERM_HPP

#include <vector>
#include "energy/energy_term.hpp"

namespace cv
{
namespace gcpw
{

/// A colour that a quad is kept near, and how firmly.
struct ColorPrior
{
    double weight = 0; ///< 0: no prior
    ColorGrid::Quad reference;
};

/// Of the quads of one image.
typedef std::vector<ColorPrior> ColorPriors;

/** @brief Keeps the colours of an image near references of their own (E_r of eq. initialfunction, and the exposures).

    E_r = sum_i weight_i sum_c ( (G_i,c - G0_i,c)^2 + (B_i,c - B0_i,c)^2 )

In the paper weight_i is 1 on quads without samples, whose reference is gain 1, bias 0, and 0 on the others. */
class ColorPriorTerm : public EnergyTerm
{
public:
    /// @param priors one for each quad of the image
    ColorPriorTerm(int image, const ColorPriors& priors) : image_(image), priors_(priors) {}

    const char* name() const override { return "color_prior"; }
    double evaluate(const State& state) const override;
    double linearize(const State& state, NormalEquations& equations) override;

    /// The equations alone: quadratic, they do not depend on a state.
    void addTo(ColorEquations& equations) const;

private:
    int image_;
    ColorPriors priors_;
};

} // namespace gcpw
} // namespace cv

#endif
