// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#include "color/color_balance.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <opencv2/core/utils/logger.hpp>
#include "color/color_priors.hpp"
#include "color/exposures.hpp"
#include "energy/color_smoothness_term.hpp"
#include "solver/color_system.hpp"

namespace cv
{
namespace gcpw
{

namespace
{

const int PASSES = 3;             ///< Newton's method on a logarithm close to its root
const double MIN_VARIANCE = 1e-5; ///< of an intensity: noise of 8-bit images, no contrast to compare

/// The two residuals of every channel, squared and linearised at the present colours.
void compare(const ColorMoments& moments, double weight, const ColorGrid::Quad& source, const ColorGrid::Quad& target,
             PhotometricBlock& own, CrossColor& other)
{
    for (int c = 0; c < CHANNELS; ++c)
    {
        const double m = moments.sourceMean(c);
        const double n = moments.targetMean(c);
        const double mean = source[c].gain * m + source[c].bias - target[c].gain * n - target[c].bias;
        own.color_color[c] = {{weight * m * m, weight * m, weight}};
        other.color_color[c] = {{weight * n * n, weight * n, weight}};
        own.color_gradient[c] = {{weight * mean * m, weight * mean}};
        other.color_gradient[c] = {{-weight * mean * n, -weight * mean}};
        other.color_cross[c] = {{-weight * m * n, -weight * m, -weight * n, -weight}};
        const double source_variance = moments.sourceVariance(c);
        const double target_variance = moments.targetVariance(c);
        if (std::min(source_variance, target_variance) < MIN_VARIANCE)
            continue;
        const double size = weight * std::sqrt(source_variance * target_variance);
        const double ratio = std::log(source[c].gain / target[c].gain) + 0.5 * std::log(source_variance / target_variance);
        own.color_color[c][0] += size / (source[c].gain * source[c].gain);
        other.color_color[c][0] += size / (target[c].gain * target[c].gain);
        other.color_cross[c][0] -= size / (source[c].gain * target[c].gain);
        own.color_gradient[c][0] += size * ratio / source[c].gain;
        other.color_gradient[c][0] -= size * ratio / target[c].gain;
    }
}

/// Samples of all comparisons, linearised at the present colours.
void accumulate(const std::vector<ColorComparison>& comparisons, double weight, const std::vector<ColorGrid>& colors, ColorSystem& system)
{
    system.clearSamples();
    for (const ColorComparison& comparison : comparisons)
        for (const QuadColors& pair : comparison.quads)
        {
            const QuadId source{comparison.source_image, pair.source_cell};
            const QuadId target{comparison.target_image, pair.target_cell};
            const ColorGrid::Quad& now = colors[source.image].quad(source.cell);
            const ColorGrid::Quad& now_other = colors[target.image].quad(target.cell);
            PhotometricBlock own;
            CrossColor other;
            compare(pair.moments, weight * pair.moments.samples() * correlationWeight(pair.moments), now, now_other, own, other);
            system.addSamples(source, own, now);
            system.addCross(source, now, target, now_other, other);
        }
}

} // namespace

std::vector<ColorGrid> balancedColors(const std::vector<OverlapSamples>& overlaps, const State& state, const Params& params)
{
    const size_t count = state.size();
    std::vector<Lattice> lattices;
    std::vector<ColorGrid> colors;
    for (const ImageState& image : state)
    {
        lattices.push_back(image.mesh.lattice());
        colors.emplace_back(image.mesh.lattice());
    }
    if (overlaps.empty())
        return colors;
    std::vector<bool> fixed(count, false);
    if (params.referenceImage >= 0 && params.referenceImage < static_cast<int>(count))
        fixed[params.referenceImage] = true;
    const std::vector<ColorComparison> comparisons = compareColors(overlaps, state);
    const std::vector<ColorGrid::Quad> exposures = estimateExposures(comparisons, fixed);
    ColorSystem system(lattices, fixed);
    std::vector<double> prior_weights;
    for (const Lattice& lattice : lattices)
        prior_weights.push_back(params.balanceWeight * lattice.cellSize().area() / (params.sampleStep * params.sampleStep));
    const std::vector<ColorPriors> priors = colorPriors(comparisons, lattices, {prior_weights, exposures},
                                                        {std::vector<double>(count, params.colorRestWeight), exposures});
    for (size_t i = 0; i < count; ++i)
    {
        ColorSmoothnessTerm(static_cast<int>(i), lattices[i], params.colorSmoothnessWeight).addTo(system);
        ColorPriorTerm(static_cast<int>(i), priors[i]).addTo(system);
    }
    const auto for_each_free = [&](const std::function<void(size_t image, ColorGrid::Quad& quad)>& change)
    {
        for (size_t i = 0; i < count; ++i)
            for (int cell = 0; !fixed[i] && cell < lattices[i].cellCount(); ++cell)
                change(i, colors[i].quad(cell));
    };
    for_each_free([&](size_t i, ColorGrid::Quad& quad) { quad = exposures[i]; });
    for (int pass = 0; pass < PASSES; ++pass)
    {
        accumulate(comparisons, params.photometricWeight, colors, system);
        // NotConverged is an answer: conjugate gradients lower the energy, and the next pass goes on from there.
        if (system.solve(colors) == SolveStatus::NotPositiveDefinite)
        {
            CV_LOG_INFO(nullptr, "gcpw: the colour balance is singular in pass " << pass << "; the last colours are kept");
            break;
        }
        for_each_free([](size_t, ColorGrid::Quad& quad)
        {
            for (ChannelAffine& map : quad)
                map.gain = plausibleGain(map.gain);
        });
    }
    return colors;
}

} // namespace gcpw
} // namespace cv
