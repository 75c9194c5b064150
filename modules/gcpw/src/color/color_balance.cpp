// Part of the GCPW module for OpenCV. Licence: Apache-2.0 (see LICENSE).
#include "color/color_balance.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <opencv2/core/utils/logger.hpp>
#include "color/color_comparison.hpp"
#include "color/color_pull.hpp"
#include "color/exposures.hpp"
#include "terms/color_smoothness_term.hpp"

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
             ColoredBlock& own, PartnerColor& other)
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
void pour(const std::vector<ColorComparison>& comparisons, double weight, const std::vector<ColorGrid>& colors, ColorSystem& system)
{
    system.clearSamples();
    for (const ColorComparison& comparison : comparisons)
        for (const PhotometricTerm::QuadColors& pair : comparison.quads)
        {
            const QuadId source{comparison.source_image, pair.source_cell};
            const QuadId target{comparison.target_image, pair.target_cell};
            const ColorGrid::Quad& now = colors[source.image].quad(source.cell);
            const ColorGrid::Quad& now_other = colors[target.image].quad(target.cell);
            ColoredBlock own;
            PartnerColor other;
            compare(pair.moments, weight * pair.moments.samples() * trustIn(pair.moments), now, now_other, own, other);
            system.addSamples(source, own, now);
            system.addPartner(source, now, target, now_other, other);
        }
}

} // namespace

std::vector<ColorGrid> balancedColors(const std::vector<PhotometricTerm>& terms, const std::vector<ImageState>& states,
                                      const Params& params)
{
    const size_t count = states.size();
    std::vector<Lattice> lattices;
    std::vector<ColorGrid> colors;
    for (const ImageState& state : states)
    {
        lattices.push_back(state.mesh.lattice());
        colors.emplace_back(state.mesh.lattice());
    }
    if (terms.empty())
        return colors;
    std::vector<bool> held(count, false);
    if (params.referenceImage >= 0 && params.referenceImage < static_cast<int>(count))
        held[params.referenceImage] = true;
    const std::vector<ColorComparison> comparisons = compareColors(terms, states);
    const std::vector<ColorGrid::Quad> exposures = estimateExposures(comparisons, held);
    ColorSystem system(lattices, held);
    for (size_t i = 0; i < count; ++i)
        addColorSmoothness(static_cast<int>(i), lattices[i], params.colorSmoothnessWeight, system);
    std::vector<double> firmly;
    for (const Lattice& lattice : lattices)
        firmly.push_back(params.balanceWeight * lattice.cellSize().area() / (params.sampleStep * params.sampleStep));
    pullColors(comparisons, lattices, {firmly, exposures}, {std::vector<double>(count, params.colorRestWeight), exposures}, system);
    const auto for_each_free = [&](const std::function<void(size_t image, ColorGrid::Quad& quad)>& change)
    {
        for (size_t i = 0; i < count; ++i)
            for (int cell = 0; !held[i] && cell < lattices[i].cellCount(); ++cell)
                change(i, colors[i].quad(cell));
    };
    for_each_free([&](size_t i, ColorGrid::Quad& quad) { quad = exposures[i]; });
    for (int pass = 0; pass < PASSES; ++pass)
    {
        pour(comparisons, params.photometricWeight, colors, system);
        // NotConverged is an answer: conjugate gradients lower the energy, and the next pass goes on from there.
        if (system.solve(colors) == SolveStatus::NotPositiveDefinite)
        {
            CV_LOG_INFO(nullptr, "gcpw: the colours of many images have no answer in pass " << pass << "; the last ones are kept");
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
