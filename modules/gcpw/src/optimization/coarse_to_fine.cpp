// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#include "optimization/coarse_to_fine.hpp"

#include <algorithm>
#include <opencv2/core/utility.hpp>
#include <opencv2/core/utils/logger.hpp>
#include "color/color_balance.hpp"
#include "color/color_priors.hpp"
#include "color/exposures.hpp"
#include "color/tone_limits.hpp"
#include "overlap/correlation.hpp"

namespace cv
{
namespace gcpw
{

namespace
{

const double FIRST_MATCH_SCALE = 32; ///< px: wide enough to follow strong parallax
const double MATCH_NARROWING = 0.5;  ///< of the matches' scale from step to step
const int MATCH_ITERATIONS = 3;      ///< at the final scale, where pixels are to follow
const int ANCHORED_ITERATIONS = 5;   ///< only the anchored regions still move
const int COLOR_PASSES = 3;          ///< of colours while the meshes stand still: each re-weights the residuals

OptimizeStatus statusOf(GaussNewton::End end, OptimizeStatus singular)
{
    return end == GaussNewton::End::Done        ? OptimizeStatus::Done
           : end == GaussNewton::End::Cancelled ? OptimizeStatus::Cancelled
                                                : singular;
}

std::vector<OverlapSamples> sampleOverlaps(const Problem& problem, int level, const Params& params)
{
    std::vector<OverlapSamples> overlaps(problem.pairs.size());
    parallel_for_(Range(0, static_cast<int>(overlaps.size())), [&](const Range& range)
    {
        for (int k = range.start; k < range.end; ++k)
        {
            const ProblemPair& pair = problem.pairs[k];
            overlaps[k] = OverlapSamples(pair.a, pair.b, problem.images[pair.a].pyramid[level], problem.images[pair.b].pyramid[level],
                                         problem.images[pair.a].rough.lattice(), params.sampleStep, params.contrastFloor, pair.shift_b);
        }
    });
    return overlaps;
}

} // namespace

CoarseToFine::CoarseToFine(const Problem& problem, const Params& params)
    : problem_(problem), params_(params), colors_(hasColors(params.method)), solver_(problem, params, colors_)
{
}

void CoarseToFine::enterLevel(int level)
{
    stage_.overlaps = sampleOverlaps(problem_, level, params_);
    stage_.scale = problem_.images.front().pyramid[level].scale;
    stage_.anchors.clear();
    stage_.color_priors.clear();
}

/** @brief The colour priors of a level, for the overlaps that its quads have in this state.

Quads with samples have a weak prior at their image's exposure: faint texture alone does not determine a gain, and along a chain
contrast would be lost from image to image. For quads without samples it is gain 1, bias 0 in a pair, as in the paper; among more
images none is the reference, so it is their image's exposure too. */
void CoarseToFine::setColorPriors(const State& state)
{
    const std::vector<ColorComparison> comparisons = compareColors(stage_.overlaps, state);
    const size_t count = state.size();
    const std::vector<ColorGrid::Quad> identity(count);
    std::vector<Lattice> lattices;
    std::vector<bool> fixed;
    for (const ProblemImage& image : problem_.images)
    {
        lattices.push_back(image.rough.lattice());
        fixed.push_back(image.fixed);
    }
    if (exposures_.empty())
        exposures_ = problem_.hasManyImages() || params_.exposureWeight > 0 ? exposuresOfAllPixels(comparisons, fixed) : identity;
    const ImagePriors compared{std::vector<double>(count, params_.exposureWeight), exposures_};
    const ImagePriors alone{std::vector<double>(count, params_.colorRestWeight), problem_.hasManyImages() ? exposures_ : identity};
    stage_.color_priors = colorPriors(comparisons, lattices, compared, alone);
}

SolveStatus CoarseToFine::initColors(State& state, int passes)
{
    if (!colors_ || stage_.overlaps.empty())
        return SolveStatus::Solved;
    setColorPriors(state);
    Energy energy = buildEnergy(problem_, params_, stage_);
    SolveStatus status = SolveStatus::Solved;
    for (int pass = 0; pass < passes && status != SolveStatus::NotPositiveDefinite; ++pass)
        status = solver_.solveColors(energy, state);
    return status;
}

GaussNewton::End CoarseToFine::runStage(State& state, int max_iterations, LevelReport& report)
{
    Energy energy = buildEnergy(problem_, params_, stage_);
    GaussNewton::Rules rules;
    rules.max_iterations = max_iterations;
    rules.stop_motion_px = params_.stopMotion * stage_.scale;
    rules.stop_gain = params_.stopGain;
    rules.colors = colors_ && !stage_.overlaps.empty();
    rules.progress = [this]
    {
        return !progress_ || progress_(std::min(1.0, static_cast<double>(iterations_++) / expected_iterations_));
    };
    report = LevelReport();
    report.scale = stage_.scale;
    return solver_.run(energy, state, rules, report);
}

GaussNewton::End CoarseToFine::fitMatches(State& state, LevelReport& report)
{
    for (double scale = FIRST_MATCH_SCALE; params_.matchScale > 0 && scale > params_.matchScale; scale *= MATCH_NARROWING)
    {
        stage_.match_scale = scale;
        const GaussNewton::End end = runStage(state, 1, report);
        if (end != GaussNewton::End::Done)
            return end;
    }
    stage_.match_scale = params_.matchScale;
    const bool pixels_follow = hasPixels(params_.method);
    return runStage(state, pixels_follow ? std::min(MATCH_ITERATIONS, params_.maxIterations) : params_.maxIterations, report);
}

/// Anchors the quads that correlate worse than at the start; false if there are none.
bool CoarseToFine::anchorWorse(const State& state, const State& start)
{
    const std::vector<OverlapSamples>& overlaps = stage_.overlaps;
    std::vector<AnchoredQuads> anchors(overlaps.size());
    parallel_for_(Range(0, static_cast<int>(overlaps.size())), [&](const Range& range)
    {
        for (int k = range.start; k < range.end; ++k)
            anchors[k] = {start[overlaps[k].sourceImage()].mesh, worseQuads(overlaps[k], state, start, params_.revertRatio)};
    });
    stage_.anchors.swap(anchors);
    return std::any_of(stage_.anchors.begin(), stage_.anchors.end(), [](const AnchoredQuads& quads) { return !quads.cells.empty(); });
}

OptimizeStatus CoarseToFine::runPyramid(State& state, std::vector<LevelReport>& report)
{
    size_t levels = static_cast<size_t>(params_.pyramidLevels);
    for (const ProblemImage& image : problem_.images)
        levels = std::min(levels, image.pyramid.size());
    const State start = state;
    const auto run_one = [&](int max_iterations)
    {
        LevelReport level_report;
        const GaussNewton::End end = runStage(state, max_iterations, level_report);
        report.push_back(level_report);
        return statusOf(end, OptimizeStatus::PixelsSingular);
    };
    for (size_t level = levels; level-- > 0;)
    {
        enterLevel(static_cast<int>(level));
        if (initColors(state, 1) == SolveStatus::NotPositiveDefinite)
            return OptimizeStatus::PixelsSingular;
        const OptimizeStatus status = run_one(params_.maxIterations);
        if (status != OptimizeStatus::Done)
            return status;
    }
    if (params_.anchorWeight > 0 && anchorWorse(state, start))
        return run_one(std::min(ANCHORED_ITERATIONS, params_.maxIterations));
    return OptimizeStatus::Done;
}

OptimizeStatus CoarseToFine::refine(State& state, std::vector<LevelReport>& report)
{
    const State rough = state;
    State matched = state;
    LevelReport match_report;
    const GaussNewton::End end = fitMatches(matched, match_report);
    if (end != GaussNewton::End::Done)
        return statusOf(end, OptimizeStatus::MatchesSingular);
    report.push_back(match_report);
    state = matched;
    const OptimizeStatus status = hasPixels(params_.method) ? runPyramid(state, report) : OptimizeStatus::Done;
    if (status == OptimizeStatus::Cancelled)
        return status;
    // Without anchors the end is not compared with the matches' meshes; with the rough alignment it always is.
    choice_ = bestCandidate(problem_, state, params_.anchorWeight > 0 ? matched : state, rough, params_.distortionPrice);
    if (choice_.best == Candidate::END)
        return status;
    // The colours belong to the meshes that were rejected.
    state = choice_.best == Candidate::MATCHES ? matched : rough;
    if (hasPixels(params_.method))
        enterLevel(0);
    if (initColors(state, COLOR_PASSES) == SolveStatus::NotPositiveDefinite)
        CV_LOG_INFO(nullptr, "gcpw: the colour equations of the meshes that were kept are singular; the last colours were kept");
    if (choice_.best == Candidate::MATCHES)
        return OptimizeStatus::MatchesKept;
    return choice_.rough_is_aligned ? OptimizeStatus::RoughAligned : OptimizeStatus::RoughKept;
}

/// The colours that are found with the meshes, or new ones, without what they would crush and blow.
void CoarseToFine::showColors(State& state) const
{
    if (!problem_.hasManyImages() && problem_.color_reference >= 0)
    {
        for (size_t i = 0; i < state.size(); ++i)
            if (!problem_.images[i].fixed)
                limitExtremes(PhotographTone(problem_.images[i].pyramid.front(), state[i].color.lattice()), state[i].color);
        return;
    }
    if (params_.balanceWeight == 0)
        return;
    std::vector<PyramidLevel> images;
    for (const ProblemImage& image : problem_.images)
        images.push_back(image.pyramid.front());
    const std::vector<ColorGrid> colors = balancedColors(images, stage_.overlaps, state, problem_.color_reference, params_);
    for (size_t i = 0; i < state.size(); ++i)
        state[i].color = colors[i];
}

OptimizeStatus CoarseToFine::run(State& state, std::vector<LevelReport>& report, const StepCallback& progress)
{
    report.clear();
    choice_ = Choice();
    stage_ = EnergyStage();
    exposures_.clear();
    progress_ = progress;
    iterations_ = 0;
    expected_iterations_ = params_.maxIterations * (hasPixels(params_.method) ? params_.pyramidLevels + 2 : 1);
    if (!hasPoints(params_.method) || problem_.pairs.empty())
        return OptimizeStatus::Done;
    const OptimizeStatus status = refine(state, report);
    const bool shown = status != OptimizeStatus::Cancelled && status != OptimizeStatus::MatchesSingular;
    if (shown && colors_)
        showColors(state);
    return status;
}

} // namespace gcpw
} // namespace cv
