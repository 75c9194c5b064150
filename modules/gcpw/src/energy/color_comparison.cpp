// Part of the GCPW module for OpenCV. Licence: Apache-2.0 (see LICENSE).
#include "energy/color_comparison.hpp"

#include <opencv2/core/utility.hpp>

namespace cv
{
namespace gcpw
{

std::vector<ColorComparison> compareColors(const std::vector<PhotometricTerm>& terms, const std::vector<ImageState>& states)
{
    std::vector<ColorComparison> comparisons(terms.size());
    parallel_for_(Range(0, static_cast<int>(terms.size())), [&](const Range& range)
    {
        for (int k = range.start; k < range.end; ++k)
            comparisons[k] = {terms[k].sourceImage(), terms[k].targetImage(), terms[k].compareColors(states)};
    });
    return comparisons;
}

} // namespace gcpw
} // namespace cv
