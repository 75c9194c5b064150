// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#include "overlap/color_comparison.hpp"

#include <algorithm>
#include <opencv2/core/utility.hpp>
#include "overlap/tone.hpp"

namespace cv
{
namespace gcpw
{

ColorComparison compareColors(const OverlapSamples& samples, const State& state)
{
    ColorComparison result{samples.sourceImage(), samples.targetImage(), {}};
    TargetLookup target = samples.targetIn(state, true);
    for (int cell = 0; cell < samples.lattice().cellCount(); ++cell)
    {
        const size_t first = result.quads.size();
        samples.visit(state, cell, target, [&](const OverlapSamples::Sample& sample, const PixelSample& pixel)
        {
            const bool clipped = isClipped(sample.value) || isClipped(pixel.value);
            const int other = target.point().cell;
            auto found = std::find_if(result.quads.begin() + first, result.quads.end(),
                                      [other](const QuadColors& item) { return item.target_cell == other; });
            if (found == result.quads.end())
                found = result.quads.insert(found, {cell, other, ColorMoments(), ColorMoments()});
            (clipped ? found->clipped : found->moments).add(sample.value, pixel.value);
        });
    }
    return result;
}

std::vector<ColorComparison> compareColors(const std::vector<OverlapSamples>& overlaps, const State& state)
{
    std::vector<ColorComparison> comparisons(overlaps.size());
    parallel_for_(Range(0, static_cast<int>(overlaps.size())), [&](const Range& range)
    {
        for (int k = range.start; k < range.end; ++k)
            comparisons[k] = compareColors(overlaps[k], state);
    });
    return comparisons;
}

} // namespace gcpw
} // namespace cv
