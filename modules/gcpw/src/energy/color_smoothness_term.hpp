// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#ifndef OPENCV_GCPW_COLOR_SMOOTHNESS_TERM_HPP
#define OPENCV_GCPW_COLOR_SMOOTHNESS_TERM_HPP

#include "energy/energy_term.hpp"

namespace cv
{
namespace gcpw
{

/** @brief Keeps the colour maps of neighbouring quads alike on all intensities (eq. colorterm).

    E_c = weight * sum_i sum_{j in N8(i)} sum_{x = 0, 0.1 .. 1} ((g_i x + b_i) - (g_j x + b_j))^2

The sum over x is the quadratic form of [sum x^2, sum x; sum x, n] in (g_i - g_j, b_i - b_j), the same for every pair. */
class ColorSmoothnessTerm : public EnergyTerm
{
public:
    ColorSmoothnessTerm(int image, const Lattice& lattice, double weight);

    const char* name() const override { return "color_smoothness"; }
    double evaluate(const State& state) const override;
    double linearize(const State& state, NormalEquations& equations) override;

    /// The equations alone: quadratic, they do not depend on a state.
    void addTo(ColorEquations& equations) const;

private:
    template <typename Visit>
    void forEachPair(Visit visit) const;

    int image_;
    Lattice lattice_;
    ColorBlock form_;
};

} // namespace gcpw
} // namespace cv

#endif
