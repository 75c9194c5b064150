// Part of the GCPW module for OpenCV. Licence: Apache-2.0 (see LICENSE).
#include "color/color_pull.hpp"

namespace cv
{
namespace gcpw
{

void pullColors(const std::vector<ColorComparison>& comparisons, const std::vector<Lattice>& lattices, const ColorPull& inside,
                const ColorPull& outside, ColorSystem& colors)
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
    colors.clearPulls();
    for (size_t i = 0; i < lattices.size(); ++i)
        for (size_t cell = 0; cell < compared[i].size(); ++cell)
        {
            const ColorPull& pull = compared[i][cell] ? inside : outside;
            if (pull.weights[i] > 0)
                colors.addPull({static_cast<int>(i), static_cast<int>(cell)}, pull.weights[i], pull.rest[i]);
        }
}

} // namespace gcpw
} // namespace cv
