// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#include "color/color_priors.hpp"

namespace cv
{
namespace gcpw
{

std::vector<ColorPriors> colorPriors(const std::vector<ColorComparison>& comparisons,
                                     const std::vector<Lattice>& lattices, const ImagePriors& compared,
                                     const ImagePriors& alone)
{
    std::vector<ColorPriors> priors;
    for (size_t i = 0; i < lattices.size(); ++i)
        priors.emplace_back(lattices[i].cellCount(), ColorPrior{alone.weights[i], alone.references[i]});
    const auto set = [&](int image, int cell) {
        priors[image][cell] = {compared.weights[image], compared.references[image]};
    };
    for (const ColorComparison& comparison : comparisons)
        for (const QuadColors& quads : comparison.quads)
        {
            set(comparison.source_image, quads.source_cell);
            set(comparison.target_image, quads.target_cell);
        }
    return priors;
}

} // namespace gcpw
} // namespace cv
