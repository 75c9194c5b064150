// Part of the GCPW module for OpenCV. Licence: Apache-2.0 (see LICENSE).
#include "energy/color_smoothness_term.hpp"

namespace cv
{
namespace gcpw
{

void addColorSmoothness(int image, const Lattice& lattice, double weight, ColorSystem& system)
{
    ColorBlock form;
    for (int i = 0; i <= 10; ++i)
    {
        const double x = 0.1 * i;
        form.gain_gain += x * x;
        form.gain_bias += x;
        form.bias_bias += 1;
    }
    // The paper's double sum meets every pair of quads twice; here each is visited once.
    form.gain_gain *= 2 * weight;
    form.gain_bias *= 2 * weight;
    form.bias_bias *= 2 * weight;
    std::array<int, 8> neighbours{};
    for (int cell = 0; cell < lattice.cellCount(); ++cell)
    {
        const int count = lattice.neighbours(cell, neighbours);
        for (int k = 0; k < count; ++k)
            if (neighbours[k] > cell)
                system.addDifference({image, cell}, {image, neighbours[k]}, form);
    }
}

} // namespace gcpw
} // namespace cv
