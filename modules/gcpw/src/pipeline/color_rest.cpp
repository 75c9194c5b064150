// Part of the GCPW module for OpenCV. Licence: Apache-2.0 (see LICENSE).
#include "pipeline/color_rest.hpp"

#include "color/color_pull.hpp"
#include "color/exposures.hpp"

namespace cv
{
namespace gcpw
{

void ColorRest::pull(const std::vector<ColorComparison>& comparisons, ColorSystem& colors)
{
    const std::vector<ColorGrid::Quad> identity(problem_.images.size());
    std::vector<Lattice> lattices;
    std::vector<bool> held;
    for (const ProblemImage& image : problem_.images)
    {
        lattices.push_back(image.rough.lattice());
        held.push_back(image.held);
    }
    if (exposures_.empty())
        exposures_ = problem_.isChain() || exposure_weight_ > 0 ? estimateExposures(comparisons, held) : identity;
    // In a pair colours fade to the photograph's own outside the overlap, as in the paper.
    pullColors(comparisons, lattices, {std::vector<double>(lattices.size(), exposure_weight_), exposures_},
               {std::vector<double>(lattices.size(), rest_weight_), problem_.isChain() ? exposures_ : identity}, colors);
}

} // namespace gcpw
} // namespace cv
