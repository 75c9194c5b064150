// Part of the GCPW module for OpenCV. Licence: Apache-2.0 (see LICENSE).
#include "pipeline/region_guard.hpp"

#include <cmath>
#include <opencv2/core/utility.hpp>

namespace cv
{
namespace gcpw
{

namespace
{

typedef PhotometricTerm::QuadMiss QuadMiss;

/// The quad's own and its neighbours' together: one quad alone is noisy.
QuadMiss around(const std::vector<QuadMiss>& misses, const Lattice& lattice, int cell)
{
    std::array<int, 8> neighbours{};
    const int count = lattice.neighbours(cell, neighbours);
    QuadMiss sum = misses[cell];
    for (int k = 0; k < count; ++k)
    {
        sum.sum += misses[neighbours[k]].sum;
        sum.samples += misses[neighbours[k]].samples;
    }
    return sum;
}

} // namespace

std::vector<int> worseQuads(const PhotometricTerm& term, const std::vector<ImageState>& images,
                            const std::vector<ImageState>& other, double ratio)
{
    const std::vector<QuadMiss> mine = term.correlate(images);
    const std::vector<QuadMiss> theirs = term.correlate(other);
    const Lattice& lattice = images[term.sourceImage()].mesh.lattice();
    std::vector<int> cells;
    for (int cell = 0; cell < lattice.cellCount(); ++cell)
    {
        const QuadMiss a = around(mine, lattice, cell);
        const QuadMiss b = around(theirs, lattice, cell);
        // mean a > ratio * mean b, without dividing by zero
        if (a.samples > 0 && b.samples > 0 && a.sum * b.samples > ratio * b.sum * a.samples)
            cells.push_back(cell);
    }
    return cells;
}

double overallMiss(const std::vector<PhotometricTerm>& terms, const std::vector<ImageState>& images)
{
    std::vector<std::vector<QuadMiss>> misses(terms.size());
    parallel_for_(Range(0, static_cast<int>(terms.size())), [&](const Range& range)
    {
        for (int k = range.start; k < range.end; ++k)
            misses[k] = terms[k].correlate(images);
    });
    double sum = 0;
    double samples = 0;
    for (const std::vector<QuadMiss>& quads : misses)
        for (const QuadMiss& miss : quads)
        {
            sum += miss.sum;
            samples += miss.samples;
        }
    return samples > 0 ? std::sqrt(sum / samples) : 0;
}

} // namespace gcpw
} // namespace cv
