// Part of the GCPW module for OpenCV. Licence: Apache-2.0 (see LICENSE).
#include "pipeline/optimizer.hpp"

#include <algorithm>
#include <opencv2/core/utility.hpp>
#include "color/color_balance.hpp"
#include "pipeline/region_guard.hpp"
#include "terms/color_smoothness_term.hpp"

namespace cv
{
namespace gcpw
{

namespace
{

const double DAMPING = 1e-4;         ///< weight of a vertex step, px^2: keeps meshes finite that nothing holds
const double STIFFEN = 5;            ///< factor on the similarity of a quad that a step would fold
const int MAX_STIFFENINGS = 3;       ///< per step; then the step is shortened there
const int MAX_HALVINGS = 4;          ///< of a step that raises the energy; then the level ends
const double FIRST_MATCH_SCALE = 32; ///< px: wide enough to follow strong parallax
const double MATCH_NARROWING = 0.5;  ///< of the matches' scale from step to step
const int MATCH_ITERATIONS = 3;      ///< at the final scale, where pixels are to follow
const int ANCHORED_ITERATIONS = 5;   ///< the anchors lead, the rest is in place already
const int COLOR_PASSES = 3;          ///< of colours for meshes at rest: residuals are weighted anew by what they then are

std::vector<Lattice> latticesOf(const Problem& problem)
{
    std::vector<Lattice> lattices;
    lattices.reserve(problem.images.size());
    for (const ProblemImage& image : problem.images)
        lattices.push_back(image.rough.lattice());
    return lattices;
}

std::vector<bool> heldOf(const Problem& problem, bool all)
{
    std::vector<bool> held;
    for (const ProblemImage& image : problem.images)
        held.push_back(all || image.held);
    return held;
}

std::vector<ColorGrid> colorsOf(const std::vector<ImageState>& states)
{
    std::vector<ColorGrid> colors;
    colors.reserve(states.size());
    for (const ImageState& state : states)
        colors.push_back(state.color);
    return colors;
}

void setColors(const std::vector<ColorGrid>& colors, std::vector<ImageState>& states)
{
    for (size_t i = 0; i < states.size(); ++i)
        states[i].color = colors[i];
}

} // namespace

Optimizer::Optimizer(const Problem& problem, const Recipe& recipe, const Params& params)
    : problem_(problem), recipe_(recipe), params_(params),
      system_(latticesOf(problem), heldOf(problem, false), heldOf(problem, !recipe.colors)),
      color_rest_(problem, params.colorRestWeight, params.exposureWeight)
{
    for (size_t i = 0; i < problem.images.size(); ++i)
    {
        const ProblemImage& image = problem.images[i];
        similarity_.emplace_back(static_cast<int>(i), image.rough, params.similarityWeight);
        guards_.emplace_back(image.rough, params.minQuadArea);
        addColorSmoothness(static_cast<int>(i), image.rough.lattice(), params.colorSmoothnessWeight, system_.colors());
    }
}

Optimizer::Poured Optimizer::pour(LevelTerms& terms, const std::vector<ImageState>& states, bool compare)
{
    system_.setZero();
    system_.addDamping(DAMPING);
    Poured poured;
    const PhotometricTerm::Energy pixels = terms.pour(states, compare, system_, poured.terms);
    for (size_t i = 0; i < states.size(); ++i)
        if (!problem_.images[i].held)
            poured.terms.similarity += similarity_[i].linearize(states[i].mesh, system_);
    if (recipe_.colors)
        poured.terms.color = system_.colors().regularEnergy(colorsOf(states));
    const double others = poured.terms.total() - poured.terms.photometric;
    poured.here = others + pixels.here;
    poured.fixed = others + pixels.fixed;
    return poured;
}

SolveStatus Optimizer::safeStep(const std::vector<ImageState>& states, MeshStep& step)
{
    const std::vector<ColorGrid> colors = colorsOf(states);
    SolveStatus status = SolveStatus::Solved;
    for (int attempt = 0;; ++attempt)
    {
        status = system_.solveMeshes(colors, step);
        if (status == SolveStatus::NotPositiveDefinite)
            return status;
        bool folds = false;
        for (size_t i = 0; i < states.size(); ++i)
        {
            if (problem_.images[i].held)
                continue;
            const std::vector<int> cells = guards_[i].violated(states[i].mesh, step[i]);
            folds = folds || !cells.empty();
            if (attempt == MAX_STIFFENINGS)
                guards_[i].shorten(states[i].mesh, step[i]);
            else
                for (int cell : cells)
                    similarity_[i].stiffen(cell, STIFFEN, system_);
        }
        if (!folds || attempt == MAX_STIFFENINGS)
            return status;
    }
}

bool Optimizer::tick()
{
    return !progress_ || progress_(std::min(1.0, static_cast<double>(ticks_++) / expected_ticks_));
}

bool Optimizer::folds(const std::vector<ImageState>& states, const MeshStep& step, double share) const
{
    for (size_t i = 0; i < states.size(); ++i)
        if (!problem_.images[i].held && !guards_[i].violated(states[i].mesh, step[i], share).empty())
            return true;
    return false;
}

/// A share of a step, and how far it moves a vertex.
double Optimizer::take(const std::vector<ImageState>& states, const MeshStep& step, const std::vector<ColorGrid>& colors,
                       double share, std::vector<ImageState>& next) const
{
    next = states;
    double motion = 0;
    for (size_t i = 0; i < states.size(); ++i)
    {
        if (problem_.images[i].held)
            continue;
        next[i].mesh = moved(states[i].mesh, step[i], share);
        motion = std::max(motion, maxVertexDistance(next[i].mesh, states[i].mesh));
        if (recipe_.colors)
            next[i].color = mixed(states[i].color, colors[i], share);
    }
    return motion;
}

Optimizer::LevelEnd Optimizer::runLevel(LevelTerms& terms, std::vector<ImageState>& states, int max_iterations,
                                        LevelReport& report)
{
    report = LevelReport();
    report.scale = terms.scale();
    for (SimilarityTerm& term : similarity_)
        term.relax();
    Poured now = pour(terms, states, false);
    terms.fix(states);
    report.start = report.end = now.terms;
    while (report.iterations < max_iterations)
    {
        report.stop = StopReason::CANCELLED;
        if (!tick())
            return LevelEnd::Cancelled;
        report.stop = StopReason::SINGULAR;
        MeshStep step;
        std::vector<ColorGrid> colors = colorsOf(states);
        // NotConverged is an answer here: conjugate gradients from zero lower the energy with every iteration, and the line
        // search has the last word.
        if (safeStep(states, step) == SolveStatus::NotPositiveDefinite)
            return LevelEnd::Singular;
        if (recipe_.colors && !terms.pixels().empty() &&
            system_.solveColorsAfter(step, colors) == SolveStatus::NotPositiveDefinite)
            return LevelEnd::Singular;
        ++report.iterations;
        const double before = now.here;
        bool accepted = false;
        double motion = 0;
        double share = 1;
        for (int halving = 0; halving <= MAX_HALVINGS && !accepted; ++halving, share *= 0.5)
        {
            if (share < 1 && folds(states, step, share)) // safeStep() has looked at the whole step
                continue;
            std::vector<ImageState> next;
            motion = take(states, step, colors, share, next);
            now = pour(terms, next, true);
            accepted = now.fixed <= before;
            if (accepted)
                states.swap(next);
        }
        report.stop = StopReason::NO_DESCENT;
        if (!accepted)
        {
            system_.setZero(); // it was poured where the meshes are not
            return LevelEnd::Done;
        }
        terms.fix(states);
        report.end = now.terms;
        report.stop = StopReason::MESH_STABLE;
        if (motion < params_.stopMotion * terms.scale())
            return LevelEnd::Done;
        report.stop = StopReason::ENERGY_STABLE;
        if (before - now.fixed < params_.stopGain * before)
            return LevelEnd::Done;
        report.stop = StopReason::ITERATION_LIMIT;
    }
    return LevelEnd::Done;
}

Optimizer::LevelEnd Optimizer::fitMatches(LevelTerms& terms, std::vector<ImageState>& states, LevelReport& report)
{
    LevelEnd end = LevelEnd::Done;
    for (double scale = FIRST_MATCH_SCALE; params_.matchScale > 0 && scale > params_.matchScale; scale *= MATCH_NARROWING)
    {
        terms.setMatchScale(scale);
        end = runLevel(terms, states, 1, report);
        if (end != LevelEnd::Done)
            return end;
    }
    terms.setMatchScale(params_.matchScale);
    return runLevel(terms, states, recipe_.pixels ? std::min(MATCH_ITERATIONS, params_.maxIterations) : params_.maxIterations, report);
}

bool Optimizer::anchorWorse(LevelTerms& terms, const std::vector<ImageState>& states,
                            const std::vector<ImageState>& start) const
{
    const std::vector<PhotometricTerm>& pixels = terms.pixels();
    std::vector<std::vector<int>> worse(pixels.size());
    parallel_for_(Range(0, static_cast<int>(pixels.size())), [&](const Range& range)
    {
        for (int k = range.start; k < range.end; ++k)
            worse[k] = worseQuads(pixels[k], states, start, params_.revertRatio);
    });
    bool any = false;
    for (size_t k = 0; k < pixels.size(); ++k)
        if (!worse[k].empty())
        {
            any = true;
            terms.anchor(k, start[pixels[k].sourceImage()].mesh, worse[k]);
        }
    return any;
}

OptimizeStatus Optimizer::runPyramid(LevelTerms& terms, std::vector<ImageState>& states, std::vector<LevelReport>& report)
{
    size_t levels = static_cast<size_t>(params_.pyramidLevels);
    for (const ProblemImage& image : problem_.images)
        levels = std::min(levels, image.pyramid.size());
    const std::vector<ImageState> start = states;
    const auto run_one = [&](int max_iterations)
    {
        LevelReport level_report;
        const LevelEnd end = runLevel(terms, states, max_iterations, level_report);
        report.push_back(level_report);
        return end;
    };
    for (size_t level = levels; level-- > 0;)
    {
        terms.enterLevel(static_cast<int>(level));
        if (initColors(terms, states) == SolveStatus::NotPositiveDefinite)
            return OptimizeStatus::PixelsSingular;
        const LevelEnd end = run_one(params_.maxIterations);
        if (end != LevelEnd::Done)
            return end == LevelEnd::Cancelled ? OptimizeStatus::Cancelled : OptimizeStatus::PixelsSingular;
    }
    if (params_.anchorWeight > 0 && anchorWorse(terms, states, start))
    {
        const LevelEnd end = run_one(std::min(ANCHORED_ITERATIONS, params_.maxIterations));
        if (end != LevelEnd::Done)
            return end == LevelEnd::Cancelled ? OptimizeStatus::Cancelled : OptimizeStatus::PixelsSingular;
    }
    return OptimizeStatus::Done;
}

/// NotConverged is an answer: the colours are then better than before.
SolveStatus Optimizer::initColors(LevelTerms& terms, std::vector<ImageState>& states)
{
    if (!recipe_.colors)
        return SolveStatus::Solved;
    color_rest_.pull(compareColors(terms.pixels(), states), system_.colors());
    std::vector<ColorGrid> colors = colorsOf(states);
    pour(terms, states, false);
    const SolveStatus status = system_.solveColors(colors);
    if (status != SolveStatus::NotPositiveDefinite)
        setColors(colors, states);
    return status;
}

OptimizeStatus Optimizer::refine(LevelTerms& terms, std::vector<ImageState>& states, std::vector<LevelReport>& report)
{
    const std::vector<ImageState> rough = states;
    std::vector<ImageState> matched = states;
    LevelReport match_report;
    const LevelEnd end = fitMatches(terms, matched, match_report);
    if (end != LevelEnd::Done)
        return end == LevelEnd::Cancelled ? OptimizeStatus::Cancelled : OptimizeStatus::MatchesSingular;
    report.push_back(match_report);
    states = matched;
    OptimizeStatus status = recipe_.pixels ? runPyramid(terms, states, report) : OptimizeStatus::Done;
    if (status == OptimizeStatus::Cancelled)
        return status;
    // Without anchors pixels have the last word over matches; over the rough alignment nothing has.
    choice_ = bestCandidate(problem_, states, params_.anchorWeight > 0 ? matched : states, rough);
    const Candidate best = choice_.best;
    if (best == Candidate::END)
        return status;
    // The colours went with the meshes that are given up.
    states = best == Candidate::MATCHES ? matched : rough;
    if (recipe_.pixels)
        terms.enterLevel(0);
    for (int pass = 0; pass < COLOR_PASSES; ++pass)
        if (initColors(terms, states) == SolveStatus::NotPositiveDefinite)
            break; // the colours of the pass before, or the photographs' own
    return best == Candidate::MATCHES ? OptimizeStatus::MatchesKept : OptimizeStatus::RoughKept;
}

OptimizeStatus Optimizer::run(std::vector<ImageState>& states, std::vector<LevelReport>& report,
                              const StepCallback& progress)
{
    report.clear();
    choice_ = Choice();
    progress_ = progress;
    ticks_ = 0;
    expected_ticks_ = params_.maxIterations * (recipe_.pixels ? params_.pyramidLevels + 2 : 1);
    if (!recipe_.points || problem_.pairs.empty())
        return OptimizeStatus::Done;
    LevelTerms terms(problem_, recipe_, params_);
    const OptimizeStatus status = refine(terms, states, report);
    const bool shown = status != OptimizeStatus::Cancelled && status != OptimizeStatus::MatchesSingular;
    if (shown && recipe_.colors && problem_.isChain() && params_.balanceWeight > 0)
        setColors(balancedColors(terms.pixels(), states, params_), states);
    return status;
}

} // namespace gcpw
} // namespace cv
