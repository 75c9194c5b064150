// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#include "energy/color_prior_term.hpp"

namespace cv
{
namespace gcpw
{

double ColorPriorTerm::evaluate(const State& state) const
{
    double energy = 0;
    for (size_t cell = 0; cell < priors_.size(); ++cell)
        for (int c = 0; c < CHANNELS; ++c)
        {
            const ChannelAffine& now = state[image_].color.quad(static_cast<int>(cell))[c];
            const double gain = now.gain - priors_[cell].reference[c].gain;
            const double bias = now.bias - priors_[cell].reference[c].bias;
            energy += priors_[cell].weight * (gain * gain + bias * bias);
        }
    return energy;
}

double ColorPriorTerm::linearize(const State& state, NormalEquations& equations)
{
    addTo(equations);
    return evaluate(state);
}

void ColorPriorTerm::addTo(ColorEquations& equations) const
{
    for (size_t cell = 0; cell < priors_.size(); ++cell)
        if (priors_[cell].weight > 0)
            equations.addColorPrior({image_, static_cast<int>(cell)}, priors_[cell].weight, priors_[cell].reference);
}

} // namespace gcpw
} // namespace cv
