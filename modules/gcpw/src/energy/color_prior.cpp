// Part of the GCPW module for OpenCV. Licence: Apache-2.0 (see LICENSE).
#include "energy/color_prior.hpp"

namespace cv
{
namespace gcpw
{

void setColorPriors(const std::vector<ColorComparison>& comparisons, const std::vector<Lattice>& lattices, const ColorPrior& inside,
                const ColorPrior& outside, ColorSystem& colors)
{
    std::vector<std::vector<bool>> compared;
    for (const Lattice& lattice : lattices)
        compared.emplace_back(lattice.cellCount(), false);
    for (const ColorComparison& comparison : comparisons)
        for (const PhotometricTerm::QuadColors& quads : comparison.quads)
        {
            compared[comparison.source_image][quads.source_cell] = true;
            compared[comparison.target_image][quads.target_cell] = true;
        }
    colors.clearPriors();
    for (size_t i = 0; i < lattices.size(); ++i)
        for (size_t cell = 0; cell < compared[i].size(); ++cell)
        {
            const ColorPrior& prior = compared[i][cell] ? inside : outside;
            if (prior.weights[i] > 0)
                colors.addPrior({static_cast<int>(i), static_cast<int>(cell)}, prior.weights[i], prior.reference[i]);
        }
}

} // namespace gcpw
} // namespace cv
