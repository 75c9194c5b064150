// Part of the GCPW module for OpenCV. Licence: Apache-2.0 (see LICENSE).
#include "optimization/level_terms.hpp"

#include <algorithm>
#include <limits>
#include <numeric>
#include <opencv2/core/utility.hpp>

namespace cv
{
namespace gcpw
{

namespace
{

/// Residuals of Params::robustScale are in local standard deviations; w_q r^2 is 0.01 times their square.
const double DEVIATION = 0.1;
const int TILE_ROWS = 8; ///< rows of quads that one thread accumulates at a time; sets the order of the sums
const int TILES_AT_ONCE = 32; ///< accumulated into buffers before these are emptied: bounds the memory

RobustLoss lossOf(double scale)
{
    return RobustLoss(scale > 0 ? scale : std::numeric_limits<double>::infinity());
}

} // namespace

LevelTerms::LevelTerms(const Problem& problem, const TermList& terms_used, const Params& params)
    : problem_(problem), terms_used_(terms_used), params_(params)
{
    for (const ProblemPair& pair : problem.pairs)
    {
        const Lattice& a = problem.images[pair.a].rough.lattice();
        const Lattice& b = problem.images[pair.b].rough.lattice();
        if (terms_used.points)
            points_.emplace_back(pair.a, pair.b, a, b, pair.matches.points, params.geometricWeight, pair.shift_b);
        if (terms_used.lines)
            lines_.emplace_back(pair.a, pair.b, a, b, pair.matches.lines, params.lineStep, params.geometricWeight,
                                pair.shift_b);
    }
    for (size_t i = 0; problem.hasManyImages() && params.restWeight > 0 && i < problem.images.size(); ++i)
    {
        std::vector<int> cells(problem.images[i].rough.lattice().cellCount());
        std::iota(cells.begin(), cells.end(), 0);
        if (!problem.images[i].fixed)
            shape_priors_.emplace_back(static_cast<int>(i), problem.images[i].rough, cells, params.restWeight);
    }
    setMatchScale(params.matchScale);
}

void LevelTerms::enterLevel(int level)
{
    PhotometricTerm::Options options;
    options.step = params_.sampleStep;
    options.weight = params_.photometricWeight;
    options.contrast_floor = params_.contrastFloor;
    options.gain_support = terms_used_.colors ? params_.gainSupport : 0;
    anchors_.clear();
    pixels_.assign(problem_.pairs.size(), PhotometricTerm());
    parallel_for_(Range(0, static_cast<int>(pixels_.size())), [&](const Range& range)
    {
        for (int k = range.start; k < range.end; ++k)
        {
            const ProblemPair& pair = problem_.pairs[k];
            pixels_[k] = PhotometricTerm(pair.a, pair.b, problem_.images[pair.a].pyramid[level],
                                         problem_.images[pair.b].pyramid[level],
                                         problem_.images[pair.a].rough.lattice(), options, pair.shift_b);
        }
    });
    scale_ = problem_.images.front().pyramid[level].scale;
    tiles_.clear();
    fixed_.clear();
    poured_.clear();
    for (const PhotometricTerm& term : pixels_)
        poured_.emplace_back(problem_.images[term.sourceImage()].rough.lattice().cellCount());
    fixed_ = poured_;
    for (size_t k = 0; k < pixels_.size(); ++k)
    {
        const Lattice& lattice = problem_.images[pixels_[k].sourceImage()].rough.lattice();
        for (int row = 0; row < lattice.rows(); row += TILE_ROWS)
            tiles_.push_back({k, Range(row * lattice.cols(), std::min(row + TILE_ROWS, lattice.rows()) * lattice.cols())});
    }
    // Misaligned regions look like outliers: coarse levels, which are to move them, judge more mildly.
    pixel_loss_ = lossOf(DEVIATION * params_.robustScale * scale_);
}

void LevelTerms::setMatchScale(double scale_px)
{
    match_loss_ = lossOf(scale_px);
}

void LevelTerms::anchor(size_t pixel_term, const MeshGrid& mesh, const std::vector<int>& cells)
{
    pixels_[pixel_term].freeze(cells);
    anchors_.emplace_back(pixels_[pixel_term].sourceImage(), mesh, cells, params_.anchorWeight);
}

PhotometricTerm::Energy LevelTerms::accumulatePixels(const std::vector<ImageState>& states, bool compare, NormalEquations& equations)
{
    PhotometricTerm::Energy total;
    buffers_.resize(TILES_AT_ONCE);
    PhotometricTerm::Energy sums[TILES_AT_ONCE];
    for (size_t first = 0; first < tiles_.size(); first += TILES_AT_ONCE)
    {
        const int count = static_cast<int>(std::min(tiles_.size() - first, static_cast<size_t>(TILES_AT_ONCE)));
        parallel_for_(Range(0, count), [&](const Range& range)
        {
            for (int i = range.start; i < range.end; ++i)
            {
                const Tile& share = tiles_[first + i];
                const PhotometricTerm& term = pixels_[share.term];
                buffers_[i].clear();
                const PhotometricTerm::Fixed before{fixed_states_, fixed_[share.term]};
                sums[i] = term.linearize(states, !problem_.images[term.targetImage()].fixed, pixel_loss_, share.cells, buffers_[i],
                                         compare ? &before : nullptr, poured_[share.term]);
            }
        }, count);
        for (int i = 0; i < count; ++i)
        {
            total.samples += sums[i].samples;
            total.here += sums[i].here;
            total.fixed += sums[i].fixed;
            buffers_[i].addTo(equations);
        }
    }
    return total;
}

void LevelTerms::fix(const std::vector<ImageState>& states)
{
    fixed_.swap(poured_);
    fixed_states_ = states;
}

PhotometricTerm::Energy LevelTerms::accumulate(const std::vector<ImageState>& states, bool compare, NormalEquations& equations,
                                         TermEnergies& energies)
{
    for (size_t k = 0; k < problem_.pairs.size(); ++k)
    {
        const MeshGrid& a = states[problem_.pairs[k].a].mesh;
        const MeshGrid& b = states[problem_.pairs[k].b].mesh;
        if (!points_.empty())
            energies.points += points_[k].linearize(a, b, match_loss_, equations);
        if (!lines_.empty())
            energies.lines += lines_[k].linearize(a, b, match_loss_, equations);
    }
    const PhotometricTerm::Energy pixels = accumulatePixels(states, compare, equations);
    energies.photometric += pixels.samples;
    for (const AnchorTerm& reference : shape_priors_)
        energies.anchors += reference.linearize(states[reference.image()].mesh, equations);
    for (const AnchorTerm& anchor : anchors_)
        energies.anchors += anchor.linearize(states[anchor.image()].mesh, equations);
    return pixels;
}

} // namespace gcpw
} // namespace cv
