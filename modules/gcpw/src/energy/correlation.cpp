// Part of the GCPW module for OpenCV. Licence: Apache-2.0 (see LICENSE).
#include "energy/correlation.hpp"

namespace cv
{
namespace gcpw
{

namespace
{

typedef PhotometricTerm::QuadDecorrelation QuadDecorrelation;

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

std::vector<int> worseQuads(const PhotometricTerm& term, const std::vector<ImageState>& images,
                            const std::vector<ImageState>& other, double ratio)
{
    const std::vector<QuadDecorrelation> mine = term.correlate(images);
    const std::vector<QuadDecorrelation> theirs = term.correlate(other);
    const Lattice& lattice = images[term.sourceImage()].mesh.lattice();
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
