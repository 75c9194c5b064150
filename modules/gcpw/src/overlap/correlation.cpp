// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#include "overlap/correlation.hpp"

#include <cmath>
#include "overlap/color_moments.hpp"

namespace cv
{
namespace gcpw
{

namespace
{

const int MIN_WINDOW_SAMPLES = 6; ///< in a quarter of a quad, to correlate

/// The quad's own and its neighbours' together: one quad alone is noisy.
QuadDecorrelation around(const std::vector<QuadDecorrelation>& decorrelations, const Lattice& lattice, int cell)
{
    std::array<int, 8> neighbours{};
    const int count = lattice.neighbours(cell, neighbours);
    QuadDecorrelation sum = decorrelations[cell];
    for (int k = 0; k < count; ++k)
    {
        sum.sum += decorrelations[neighbours[k]].sum;
        sum.samples += decorrelations[neighbours[k]].samples;
    }
    return sum;
}

} // namespace

std::vector<QuadDecorrelation> quadDecorrelations(const OverlapSamples& samples, const State& state)
{
    std::vector<QuadDecorrelation> result(samples.lattice().cellCount());
    TargetLookup target = samples.targetIn(state, false);
    for (int cell = 0; cell < samples.lattice().cellCount(); ++cell)
    {
        PairSums quarters[4];
        samples.visit(state, cell, target, [&](const OverlapSamples::Sample& sample, const PixelSample& pixel)
        {
            const bool right = sample.weight[1] + sample.weight[3] > 0.5F;
            const bool bottom = sample.weight[2] + sample.weight[3] > 0.5F;
            quarters[(right ? 1 : 0) + (bottom ? 2 : 0)].add(sample.value[0], pixel.value[0]);
        });
        for (const PairSums& m : quarters)
        {
            if (m.n < MIN_WINDOW_SAMPLES)
                continue;
            const double va = m.aa - m.a * m.a / m.n;
            const double vb = m.bb - m.b * m.b / m.n;
            if (va < TEXTURE_VARIANCE * m.n || vb < TEXTURE_VARIANCE * m.n)
                continue;
            const double decorrelation = 1 - (m.ab - m.a * m.b / m.n) / std::sqrt(va * vb);
            result[cell].sum += m.n * decorrelation * decorrelation;
            result[cell].samples += static_cast<int>(m.n);
        }
    }
    return result;
}

std::vector<int> worseQuads(const OverlapSamples& samples, const State& state, const State& other, double ratio)
{
    const std::vector<QuadDecorrelation> mine = quadDecorrelations(samples, state);
    const std::vector<QuadDecorrelation> theirs = quadDecorrelations(samples, other);
    const Lattice& lattice = samples.lattice();
    std::vector<int> cells;
    for (int cell = 0; cell < lattice.cellCount(); ++cell)
    {
        const QuadDecorrelation a = around(mine, lattice, cell);
        const QuadDecorrelation b = around(theirs, lattice, cell);
        // mean a > ratio * mean b, without dividing by zero
        if (a.samples > 0 && b.samples > 0 && a.sum * b.samples > ratio * b.sum * a.samples)
            cells.push_back(cell);
    }
    return cells;
}

} // namespace gcpw
} // namespace cv
