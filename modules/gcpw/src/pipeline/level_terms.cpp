// Part of the GCPW module for OpenCV. Licence: Apache-2.0 (see LICENSE).
#include "pipeline/level_terms.hpp"

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
const int SHARE_ROWS = 8; ///< rows of quads that one thread pours at a time; sets the order of the sums
const int SHARES_AT_ONCE = 32; ///< poured into buffers before these are emptied: bounds the memory

RobustLoss lossOf(double scale)
{
    return RobustLoss(scale > 0 ? scale : std::numeric_limits<double>::infinity());
}

} // namespace

LevelTerms::LevelTerms(const Problem& problem, const Recipe& recipe, const Params& params)
    : problem_(problem), recipe_(recipe), params_(params)
{
    for (const ProblemPair& pair : problem.pairs)
    {
        const Lattice& a = problem.images[pair.a].rough.lattice();
        const Lattice& b = problem.images[pair.b].rough.lattice();
        if (recipe.points)
            points_.emplace_back(pair.a, pair.b, a, b, pair.matches.points, params.geometricWeight, pair.shift_b);
        if (recipe.lines)
            lines_.emplace_back(pair.a, pair.b, a, b, pair.matches.lines, params.lineStep, params.geometricWeight,
                                pair.shift_b);
    }
    for (size_t i = 0; problem.isChain() && params.restWeight > 0 && i < problem.images.size(); ++i)
    {
        std::vector<int> cells(problem.images[i].rough.lattice().cellCount());
        std::iota(cells.begin(), cells.end(), 0);
        if (!problem.images[i].held)
            rests_.emplace_back(static_cast<int>(i), problem.images[i].rough, cells, params.restWeight);
    }
    setMatchScale(params.matchScale);
}

void LevelTerms::enterLevel(int level)
{
    PhotometricTerm::Options options;
    options.step = params_.sampleStep;
    options.weight = params_.photometricWeight;
    options.contrast_floor = params_.contrastFloor;
    options.gain_support = recipe_.colors ? params_.gainSupport : 0;
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
    shares_.clear();
    fixed_.clear();
    poured_.clear();
    for (const PhotometricTerm& term : pixels_)
        poured_.emplace_back(problem_.images[term.sourceImage()].rough.lattice().cellCount());
    fixed_ = poured_;
    for (size_t k = 0; k < pixels_.size(); ++k)
    {
        const Lattice& lattice = problem_.images[pixels_[k].sourceImage()].rough.lattice();
        for (int row = 0; row < lattice.rows(); row += SHARE_ROWS)
            shares_.push_back({k, Range(row * lattice.cols(), std::min(row + SHARE_ROWS, lattice.rows()) * lattice.cols())});
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

PhotometricTerm::Energy LevelTerms::pourPixels(const std::vector<ImageState>& states, bool compare, ResidualSink& sink)
{
    PhotometricTerm::Energy total;
    buffers_.resize(SHARES_AT_ONCE);
    PhotometricTerm::Energy sums[SHARES_AT_ONCE];
    for (size_t first = 0; first < shares_.size(); first += SHARES_AT_ONCE)
    {
        const int count = static_cast<int>(std::min(shares_.size() - first, static_cast<size_t>(SHARES_AT_ONCE)));
        parallel_for_(Range(0, count), [&](const Range& range)
        {
            for (int i = range.start; i < range.end; ++i)
            {
                const Share& share = shares_[first + i];
                const PhotometricTerm& term = pixels_[share.term];
                buffers_[i].clear();
                const PhotometricTerm::Fixed before{fixed_states_, fixed_[share.term]};
                sums[i] = term.linearize(states, !problem_.images[term.targetImage()].held, pixel_loss_, share.cells, buffers_[i],
                                         compare ? &before : nullptr, poured_[share.term]);
            }
        }, count);
        for (int i = 0; i < count; ++i)
        {
            total.samples += sums[i].samples;
            total.here += sums[i].here;
            total.fixed += sums[i].fixed;
            buffers_[i].pourInto(sink);
        }
    }
    return total;
}

void LevelTerms::fix(const std::vector<ImageState>& states)
{
    fixed_.swap(poured_);
    fixed_states_ = states;
}

PhotometricTerm::Energy LevelTerms::pour(const std::vector<ImageState>& states, bool compare, ResidualSink& sink,
                                         TermEnergies& energies)
{
    for (size_t k = 0; k < problem_.pairs.size(); ++k)
    {
        const MeshGrid& a = states[problem_.pairs[k].a].mesh;
        const MeshGrid& b = states[problem_.pairs[k].b].mesh;
        if (!points_.empty())
            energies.points += points_[k].linearize(a, b, match_loss_, sink);
        if (!lines_.empty())
            energies.lines += lines_[k].linearize(a, b, match_loss_, sink);
    }
    const PhotometricTerm::Energy pixels = pourPixels(states, compare, sink);
    energies.photometric += pixels.samples;
    for (const AnchorTerm& rest : rests_)
        energies.anchors += rest.linearize(states[rest.image()].mesh, sink);
    for (const AnchorTerm& anchor : anchors_)
        energies.anchors += anchor.linearize(states[anchor.image()].mesh, sink);
    return pixels;
}

} // namespace gcpw
} // namespace cv
