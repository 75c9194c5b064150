// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#include "energy/color_smoothness_term.hpp"

namespace cv
{
namespace gcpw
{

ColorSmoothnessTerm::ColorSmoothnessTerm(int image, const Lattice& lattice, double weight) : image_(image), lattice_(lattice)
{
    for (int i = 0; i <= 10; ++i)
    {
        const double x = 0.1 * i;
        form_.gain_gain += x * x;
        form_.gain_bias += x;
        form_.bias_bias += 1;
    }
    // The paper's double sum has every pair of quads twice; here each is visited once.
    form_.gain_gain *= 2 * weight;
    form_.gain_bias *= 2 * weight;
    form_.bias_bias *= 2 * weight;
}

/// Calls visit(cell, neighbour) once for every two quads that touch.
template <typename Visit>
void ColorSmoothnessTerm::forEachPair(Visit visit) const
{
    std::array<int, 8> neighbours{};
    for (int cell = 0; cell < lattice_.cellCount(); ++cell)
    {
        const int count = lattice_.neighbours(cell, neighbours);
        for (int k = 0; k < count; ++k)
            if (neighbours[k] > cell)
                visit(cell, neighbours[k]);
    }
}

double ColorSmoothnessTerm::evaluate(const State& state) const
{
    const ColorGrid& color = state[image_].color;
    double energy = 0;
    forEachPair([&](int cell, int neighbour)
    {
        for (int c = 0; c < CHANNELS; ++c)
        {
            const double gain = color.quad(cell)[c].gain - color.quad(neighbour)[c].gain;
            const double bias = color.quad(cell)[c].bias - color.quad(neighbour)[c].bias;
            energy += form_.gain_gain * gain * gain + 2 * form_.gain_bias * gain * bias + form_.bias_bias * bias * bias;
        }
    });
    return energy;
}

double ColorSmoothnessTerm::linearize(const State& state, NormalEquations& equations)
{
    addTo(equations);
    return evaluate(state);
}

void ColorSmoothnessTerm::addTo(ColorEquations& equations) const
{
    forEachPair([&](int cell, int neighbour)
    {
        equations.addColorDifference({image_, cell}, {image_, neighbour}, form_);
    });
}

} // namespace gcpw
} // namespace cv
