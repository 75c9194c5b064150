// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#include "energy/photometric_term.hpp"

#include <algorithm>

namespace cv
{
namespace gcpw
{

namespace
{

const int PART_ROWS = 8; ///< rows of quads that one thread works on at a time; sets the order of the sums

/// Residual of a sample in every channel, as the colours of its quads have it; returns the sum of squares.
double residualOf(const float* source, const float* target, const ColorGrid::Quad& mine, const ColorGrid::Quad& theirs,
                  double* residual)
{
    double squared = 0;
    for (int c = 0; c < CHANNELS; ++c)
    {
        residual[c] = mine[c].gain * source[c] + mine[c].bias - theirs[c].gain * target[c] - theirs[c].bias;
        squared += residual[c] * residual[c];
    }
    return squared;
}

} // namespace

PhotometricTerm::PhotometricTerm(const OverlapSamples& samples, const Options& options, const std::vector<int>& frozen_cells)
    : samples_(samples), options_(options), mesh_frozen_(samples.lattice().cellCount(), false),
      weights_(samples.lattice().cellCount())
{
    for (int cell : frozen_cells)
        mesh_frozen_[cell] = true;
}

int PhotometricTerm::parts() const
{
    return (samples_.lattice().rows() + PART_ROWS - 1) / PART_ROWS;
}

Range PhotometricTerm::cellsOf(int part) const
{
    const Lattice& lattice = samples_.lattice();
    return {part * PART_ROWS * lattice.cols(), std::min((part + 1) * PART_ROWS, lattice.rows()) * lattice.cols()};
}

double PhotometricTerm::evaluate(const State& state) const
{
    return evaluateCells(state, Range(0, samples_.lattice().cellCount()));
}

double PhotometricTerm::evaluatePart(const State& state, int part) const
{
    return evaluateCells(state, cellsOf(part));
}

double PhotometricTerm::linearize(const State& state, NormalEquations& equations)
{
    target_color_ = state[samples_.targetImage()].color;
    return linearizeCells(state, Range(0, samples_.lattice().cellCount()), equations);
}

double PhotometricTerm::linearizePart(const State& state, int part, NormalEquations& equations)
{
    if (part == 0) // read by evaluate() only
        target_color_ = state[samples_.targetImage()].color;
    return linearizeCells(state, cellsOf(part), equations);
}

double PhotometricTerm::evaluateCells(const State& state, Range cells) const
{
    const ColorGrid& source_color = state[samples_.sourceImage()].color;
    const ColorGrid& target_color = state[samples_.targetImage()].color;
    TargetLookup target = samples_.targetIn(state, options_.target_moves);
    double total = 0;
    for (int cell = cells.start; cell < cells.end; ++cell)
    {
        const FrozenWeights& weights = weights_[cell];
        const ColorGrid::Quad& now = source_color.quad(cell);
        const bool blended = weights.correlation_weight < 1;
        double energy = 0;
        double former = 0; // with the colours of the last linearisation
        double ignored[CHANNELS];
        samples_.visit(state, cell, target, [&](const OverlapSamples::Sample& sample, const PixelSample& pixel)
        {
            const int other = target.point().cell;
            energy += options_.loss.value(
                sample.importance * residualOf(sample.value, pixel.value, now, target_color.quad(other), ignored));
            if (blended)
                former += options_.loss.value(
                    sample.importance * residualOf(sample.value, pixel.value, weights.color, target_color_.quad(other), ignored));
        });
        total += options_.weight * (weights.correlation_weight * energy + (1 - weights.correlation_weight) * former) +
                 weights.extras(now, target_color);
    }
    return total;
}

double PhotometricTerm::linearizeCells(const State& state, Range cells, NormalEquations& equations)
{
    const ColorGrid& source_color = state[samples_.sourceImage()].color;
    const ColorGrid& target_color = state[samples_.targetImage()].color;
    TargetLookup target = samples_.targetIn(state, options_.target_moves);
    std::vector<std::pair<int, CrossSums>> cross; // target cell, sums; a handful at most
    double total = 0;
    for (int cell = cells.start; cell < cells.end; ++cell)
    {
        const ColorGrid::Quad& now = source_color.quad(cell);
        SampleSums sums;
        cross.clear();
        double energy = 0;
        samples_.visit(state, cell, target, [&](const OverlapSamples::Sample& sample, const PixelSample& pixel)
        {
            const int other = target.point().cell;
            LinearSample linear;
            const double squared =
                sample.importance * residualOf(sample.value, pixel.value, now, target_color.quad(other), linear.residual);
            for (int c = 0; c < CHANNELS; ++c)
            {
                linear.mine[c] = sample.value[c];
                linear.theirs[c] = pixel.value[c];
            }
            target.gradient(pixel, linear.gx, linear.gy);
            linear.weight = options_.loss.weight(squared) * sample.importance;
            energy += options_.loss.value(squared);
            sums.add(sample.weight, linear);
            if (!options_.target_moves)
                return;
            auto found = std::find_if(cross.begin(), cross.end(),
                                      [other](const std::pair<int, CrossSums>& item) { return item.first == other; });
            if (found == cross.end())
                found = cross.insert(found, {other, CrossSums()});
            found->second.add(sample.weight, target.point().weight.data(), linear);
        }, samplePixel);
        weights_[cell].clear();
        if (sums.samples() == 0)
            continue;
        PhotometricBlock block = sums.block(options_.weight);
        block.energy = options_.weight * energy;
        addQuad(state, cell, sums, cross, block, equations);
        total += block.energy;
    }
    return total;
}

void PhotometricTerm::addQuad(const State& state, int cell, const SampleSums& sums,
                              const std::vector<std::pair<int, CrossSums>>& cross, PhotometricBlock& block,
                              NormalEquations& equations)
{
    const ColorGrid::Quad& now = state[samples_.sourceImage()].color.quad(cell);
    const ColorGrid& target_color = state[samples_.targetImage()].color;
    FrozenWeights& weights = weights_[cell];
    weights.color = now;
    const bool reweighted = options_.gain_support > 0;
    if (reweighted)
        sums.reweightColors(now, options_.weight, options_.target_moves ? 0 : options_.gain_support, block, weights);
    for (const std::pair<int, CrossSums>& item : cross)
    {
        CrossBlock other = item.second.block(options_.weight);
        if (reweighted)
            weights.other_quads.push_back({item.first, item.second.reweightColors(now, target_color.quad(item.first), options_.weight,
                                                                                  weights.correlation_weight, block, other)});
        if (mesh_frozen_[cell])
        {
            other.cross = other.mesh_mesh = QuadBlock{};
            other.mesh_gradient = QuadRow{};
        }
        equations.addCross({samples_.sourceImage(), cell}, {samples_.targetImage(), item.first}, other);
    }
    if (mesh_frozen_[cell])
    {
        block.mesh_mesh = QuadBlock{};
        block.mesh_gradient = QuadRow{};
        block.mesh_color = {};
    }
    equations.addPhotometric({samples_.sourceImage(), cell}, block);
}

} // namespace gcpw
} // namespace cv
