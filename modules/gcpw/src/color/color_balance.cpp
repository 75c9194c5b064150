// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#include "color/color_balance.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <opencv2/core/utils/logger.hpp>
#include "color/color_agreement.hpp"
#include "color/color_priors.hpp"
#include "color/exposures.hpp"
#include "color/tone_limits.hpp"
#include "energy/color_smoothness_term.hpp"
#include "overlap/tone.hpp"
#include "solver/color_system.hpp"
#include "solver/robust_loss.hpp"

namespace cv
{
namespace gcpw
{

namespace
{

const int PASSES = 5;         ///< of re-weighting and of Newton's method on a logarithm
const double REST = 0.2;      ///< of the prior of a compared quad is that of another: its colour fades over some quads
const double DEVIATIONS = 10; ///< robust standard deviations: wide, as light may differ from place to place
const double HUE = 0.7; ///< weight of Cr and Cb against Y: a tint of a part is seen sooner than a step of hue at a cut
const double TINT = 30.0 / 255; ///< local difference of hue beyond which two images show two things, not two lights
/// Weights of E_k, in Params::balanceWeight: beside a comparison of means at 1/3 of the range they are about 1/15, 1/20 and 1.
const double KEEP_LIGHT = 2;      ///< of the gain of Y
const double KEEP_HUE = 10;       ///< of a shift of Cr and Cb
const double KEEP_BLACK = 30;     ///< of a bias of Y, and of a gain of Cr and Cb of the quad's own
const double MIN_VARIANCE = 1e-5; ///< of an intensity: noise of 8-bit images, no contrast to compare

/// How much one comparison of two quads counts in Y, and in Cr and Cb.
struct ChannelWeights
{
    double luma;
    double hue;

    double of(int channel) const { return channel == 0 ? luma : hue; }
};

/// The colours of two quads that are compared, and what that says about them, squared and linearised there.
struct Comparison
{
    const ColorGrid::Quad& source;
    const ColorGrid::Quad& target;
    int channels; ///< the first of Y, Cr, Cb
    SampleColor own;
    CrossColor other;

    void addMeans(const ColorMoments& moments, const ChannelWeights& weights)
    {
        for (int c = 0; c < channels; ++c)
        {
            const double weight = weights.of(c);
            const double m = moments.sourceMean(c);
            const double n = moments.targetMean(c);
            const double mean = source[c].gain * m + source[c].bias - target[c].gain * n - target[c].bias;
            addTo(own.color_color[c], {{weight * m * m, weight * m, weight}});
            addTo(other.color_color[c], {{weight * n * n, weight * n, weight}});
            addTo(own.color_gradient[c], {{weight * mean * m, weight * mean}});
            addTo(other.color_gradient[c], {{-weight * mean * n, -weight * mean}});
            addTo(other.color_cross[c], {{-weight * m * n, -weight * m, -weight * n, -weight}});
        }
    }

    void addContrasts(const ColorMoments& moments, const ChannelWeights& weights)
    {
        for (int c = 0; c < channels; ++c)
        {
            const double source_variance = moments.sourceVariance(c);
            const double target_variance = moments.targetVariance(c);
            if (std::min(source_variance, target_variance) < MIN_VARIANCE)
                continue;
            const double size = weights.of(c) * std::sqrt(source_variance * target_variance);
            const double ratio =
                std::log(source[c].gain / target[c].gain) + 0.5 * std::log(source_variance / target_variance);
            own.color_color[c][0] += size / (source[c].gain * source[c].gain);
            other.color_color[c][0] += size / (target[c].gain * target[c].gain);
            other.color_cross[c][0] -= size / (source[c].gain * target[c].gain);
            own.color_gradient[c][0] += size * ratio / source[c].gain;
            other.color_gradient[c][0] -= size * ratio / target[c].gain;
        }
    }

private:
    template <size_t N>
    static void addTo(std::array<double, N>& sum, const std::array<double, N>& values)
    {
        for (size_t i = 0; i < N; ++i)
            sum[i] += values[i];
    }
};

/// The images that comparisons connect, directly or not: each has the number of one of them.
std::vector<int> groupsOf(const std::vector<ColorComparison>& comparisons, size_t count)
{
    std::vector<int> group(count);
    std::iota(group.begin(), group.end(), 0);
    for (const ColorComparison& comparison : comparisons)
        if (!comparison.quads.empty())
        {
            const int from = group[comparison.source_image];
            const int to = group[comparison.target_image];
            std::replace(group.begin(), group.end(), std::max(from, to), std::min(from, to));
        }
    return group;
}

/// The colours of all images, as they are improved.
class Balance
{
public:
    Balance(const std::vector<PyramidLevel>& images, const std::vector<OverlapSamples>& overlaps, const State& state,
            const std::vector<bool>& fixed, const Params& params)
        : params_(params), comparisons_(compareColors(overlaps, state)),
          likeness_(likenessOf(comparisons_)), gauge_{fixed, grayImages(comparisons_, state.size()),
                                                      groupsOf(comparisons_, state.size())},
          referenced_(gauge_.hasReference()),
          exposures_(referenced_ ? estimateExposures(comparisons_, fixed) : sharedLights(comparisons_, state.size()))
    {
        for (size_t i = 0; i < state.size(); ++i)
        {
            lattices_.push_back(state[i].mesh.lattice());
            colors_.emplace_back(lattices_.back());
            tones_.emplace_back(images[i], lattices_.back());
            for (int cell = 0; !gauge_.fixed[i] && cell < lattices_[i].cellCount(); ++cell)
                colors_[i].quad(cell) = exposures_[i];
        }
    }

    std::vector<ColorGrid> run()
    {
        for (int pass = 0; pass < PASSES; ++pass)
        {
            // NotConverged is an answer: conjugate gradients lower the energy, and the next pass goes on from there.
            if (solve() == SolveStatus::NotPositiveDefinite)
            {
                CV_LOG_INFO(nullptr,
                            "gcpw: the colour balance is singular in pass " << pass << "; the last colours are kept");
                break;
            }
            for (size_t i = 0; i < colors_.size(); ++i)
                for (int cell = 0; !gauge_.fixed[i] && cell < lattices_[i].cellCount(); ++cell)
                    for (ChannelAffine& map : colors_[i].quad(cell))
                        map.gain = plausibleGain(map.gain);
        }
        limitTones(tones_, comparisons_, gauge_, colors_);
        return colors_;
    }

private:
    /// E_k: draws the colours of an image to those of its photograph.
    void addKeeping(int image, double weight, ColorSystem& system) const
    {
        const ColorGrid::Quad& kept = exposures_[image];
        for (int cell = 0; cell < lattices_[image].cellCount(); ++cell)
        {
            const ColorGrid::Quad& now = colors_[image].quad(cell);
            SampleColor sums;
            sums.color_color[0] = {{KEEP_LIGHT * weight, 0, KEEP_BLACK * weight}};
            sums.color_gradient[0] = {{KEEP_LIGHT * weight * (now[0].gain - kept[0].gain),
                                       KEEP_BLACK * weight * (now[0].bias - kept[0].bias)}};
            for (int c = 1; c < CHANNELS; ++c)
            {
                const double gain = now[c].gain - kept[c].gain;
                const double shift = NEUTRAL * gain + now[c].bias - kept[c].bias; // of gray
                sums.color_color[c] = {{weight * (KEEP_BLACK + NEUTRAL * NEUTRAL * KEEP_HUE),
                                        weight * NEUTRAL * KEEP_HUE, weight * KEEP_HUE}};
                sums.color_gradient[c] = {
                    {weight * (KEEP_BLACK * gain + NEUTRAL * KEEP_HUE * shift), weight * KEEP_HUE * shift}};
            }
            system.addSamples({image, cell}, sums, now);
        }
    }

    SolveStatus solve()
    {
        const size_t count = colors_.size();
        ColorSystem system(lattices_, gauge_.fixed);
        const double whole = 1 / static_cast<double>(params_.sampleStep * params_.sampleStep);
        std::vector<double> weights;
        std::vector<double> rest;
        for (const Lattice& lattice : lattices_)
        {
            weights.push_back(params_.balanceWeight * lattice.cellSize().area() * whole);
            rest.push_back(std::max(params_.colorRestWeight, REST * weights.back()));
        }
        std::vector<ColorPriors> priors(count);
        if (referenced_)
            priors = colorPriors(comparisons_, lattices_, {weights, exposures_}, {rest, exposures_});
        for (size_t i = 0; i < count; ++i)
        {
            ColorSmoothnessTerm(static_cast<int>(i), lattices_[i], params_.colorSmoothnessWeight).addTo(system);
            if (referenced_)
                ColorPriorTerm(static_cast<int>(i), priors[i]).addTo(system);
            else
                addKeeping(static_cast<int>(i), weights[i], system);
        }
        addComparisons(system);
        return system.solve(colors_);
    }

    /// Less in hue where that differs by more than any light between two photographs.
    ChannelWeights weightsOf(const ColorMoments& moments, double agreement, int source, int target) const
    {
        double squared = 0;
        for (int c = 1; c < CHANNELS; ++c)
        {
            const ChannelAffine& a = exposures_[source][c];
            const ChannelAffine& b = exposures_[target][c];
            squared += std::pow(a.gain * moments.sourceMean(c) + a.bias - b.gain * moments.targetMean(c) - b.bias, 2);
        }
        const double weight = params_.photometricWeight * moments.samples() * agreement;
        return {weight, HUE * weight * RobustLoss(TINT).weight(squared)};
    }

    /// What the overlaps say, linearised at the present colours.
    void addComparisons(ColorSystem& system) const
    {
        const ColorOf colors = [this](int image, int cell) -> const ColorGrid::Quad&
        { return colors_[image].quad(cell); };
        const QuadWeights agreement = agreementOf(comparisons_, likeness_, gauge_.gray, colors, DEVIATIONS);
        for (size_t k = 0; k < comparisons_.size(); ++k)
            for (size_t q = 0; q < comparisons_[k].quads.size(); ++q)
            {
                const QuadColors& pair = comparisons_[k].quads[q];
                const QuadId source{comparisons_[k].source_image, pair.source_cell};
                const QuadId target{comparisons_[k].target_image, pair.target_cell};
                Comparison comparison{colors(source.image, source.cell), colors(target.image, target.cell),
                                      comparableChannels(comparisons_[k], gauge_.gray), SampleColor(), CrossColor()};
                if (pair.moments.samples() > 0)
                {
                    const ChannelWeights weights =
                        weightsOf(pair.moments, agreement[k][q].moments, source.image, target.image);
                    comparison.addMeans(pair.moments, weights);
                    if (referenced_)
                        comparison.addContrasts(pair.moments, weights);
                }
                if (pair.clipped.samples() > 0) // they have lost their contrast
                    comparison.addMeans(pair.clipped,
                                        weightsOf(pair.clipped, agreement[k][q].clipped, source.image, target.image));
                system.addSamples(source, comparison.own, comparison.source);
                system.addCross(source, comparison.source, target, comparison.target, comparison.other);
            }
    }

    const Params& params_;
    std::vector<ColorComparison> comparisons_;
    QuadWeights likeness_;
    ToneGauge gauge_;
    bool referenced_; ///< an image is fixed, and the others take its light
    std::vector<ColorGrid::Quad> exposures_;
    std::vector<Lattice> lattices_;
    std::vector<PhotographTone> tones_;
    std::vector<ColorGrid> colors_;
};

} // namespace

std::vector<ColorGrid> balancedColors(const std::vector<PyramidLevel>& images,
                                      const std::vector<OverlapSamples>& overlaps, const State& state, int reference,
                                      const Params& params)
{
    CV_DbgAssert(images.size() == state.size());
    if (overlaps.empty())
    {
        std::vector<ColorGrid> untouched;
        for (const ImageState& image : state)
            untouched.emplace_back(image.mesh.lattice());
        return untouched;
    }
    std::vector<bool> fixed(state.size(), false);
    if (reference >= 0 && reference < static_cast<int>(state.size()))
        fixed[reference] = true;
    return Balance(images, overlaps, state, fixed, params).run();
}

} // namespace gcpw
} // namespace cv
