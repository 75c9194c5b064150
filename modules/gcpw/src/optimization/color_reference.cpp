// Part of the GCPW module for OpenCV. Licence: Apache-2.0 (see LICENSE).
#include "optimization/color_reference.hpp"

#include "energy/color_prior.hpp"
#include "color/exposures.hpp"

namespace cv
{
namespace gcpw
{

void ColorReference::prior(const std::vector<ColorComparison>& comparisons, ColorSystem& colors)
{
    const std::vector<ColorGrid::Quad> identity(problem_.images.size());
    std::vector<Lattice> lattices;
    std::vector<bool> fixed;
    for (const ProblemImage& image : problem_.images)
    {
        lattices.push_back(image.rough.lattice());
        fixed.push_back(image.fixed);
    }
    if (exposures_.empty())
        exposures_ = problem_.hasManyImages() || exposure_weight_ > 0 ? estimateExposures(comparisons, fixed) : identity;
    // In a pair colours fade to the photograph's own outside the overlap, as in the paper.
    setColorPriors(comparisons, lattices, {std::vector<double>(lattices.size(), exposure_weight_), exposures_},
               {std::vector<double>(lattices.size(), outside_weight_), problem_.hasManyImages() ? exposures_ : identity}, colors);
}

} // namespace gcpw
} // namespace cv
