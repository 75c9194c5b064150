// Part of the GCPW module for OpenCV. Licence: Apache-2.0 (see LICENSE).
#include "pipeline/optimizer.hpp"

#include <algorithm>
#include <cmath>
#include "terms/color_smoothness_term.hpp"

namespace cv
{
namespace gcpw
{

namespace
{

const double DAMPING = 1e-4;     ///< weight of a vertex step, px^2: keeps meshes finite that nothing holds
const double STIFFEN = 5;        ///< factor on the similarity of a quad that a step would fold
const int MAX_STIFFENINGS = 6;   ///< per step; then the step is shortened
const int MAX_HALVINGS = 4;      ///< of a step that raises the energy; then the level ends

std::vector<Lattice> latticesOf(const Problem& problem)
{
    std::vector<Lattice> lattices;
    for (const ProblemImage& image : problem.images)
        lattices.push_back(image.rough.lattice());
    return lattices;
}

std::vector<bool> heldOf(const Problem& problem, bool all = false)
{
    std::vector<bool> held;
    for (const ProblemImage& image : problem.images)
        held.push_back(all || image.held);
    return held;
}

std::vector<ColorGrid> colorsOf(const std::vector<ImageState>& states)
{
    std::vector<ColorGrid> colors;
    for (const ImageState& state : states)
        colors.push_back(state.color);
    return colors;
}

double robustScale(const std::vector<PhotometricTerm>& terms, const std::vector<ImageState>& states, double factor)
{
    std::vector<float> squared;
    for (const PhotometricTerm& term : terms)
    {
        const std::vector<float> part = term.squaredResiduals(states);
        squared.insert(squared.end(), part.begin(), part.end());
    }
    if (factor <= 0 || squared.empty())
        return std::numeric_limits<double>::infinity();
    std::nth_element(squared.begin(), squared.begin() + squared.size() / 2, squared.end());
    const double deviation = 1.4826 * std::sqrt(squared[squared.size() / 2]);
    return std::max(factor * deviation, 1e-3);
}

} // namespace

/// The terms of one pyramid level.
struct Optimizer::Level
{
    Recipe recipe;
    double scale = 1;
    std::vector<PointTerm> points;
    std::vector<PointTerm> dense;
    std::vector<LineTerm> lines;
    std::vector<PhotometricTerm> pixels;
    RobustLoss match_loss;
    RobustLoss pixel_loss;
};

Optimizer::Optimizer(const Problem& problem, const Params& params)
    : problem_(problem), params_(params),
      system_(latticesOf(problem), heldOf(problem), heldOf(problem))
{
    for (size_t i = 0; i < problem.images.size(); ++i)
    {
        const ProblemImage& image = problem.images[i];
        similarity_.emplace_back(static_cast<int>(i), image.rough, params.similarityWeight);
        guards_.emplace_back(image.rough, params.minQuadArea);
        addColorSmoothness(static_cast<int>(i), image.rough.lattice(), params.colorSmoothnessWeight, system_.colors());
    }
}

Optimizer::Poured Optimizer::pour(const Level& level, const std::vector<ImageState>& states)
{
    system_.setZero();
    system_.addDamping(DAMPING);
    Poured poured;
    for (size_t k = 0; k < problem_.pairs.size(); ++k)
    {
        const ProblemPair& pair = problem_.pairs[k];
        const MeshGrid& a = states[pair.a].mesh;
        const MeshGrid& b = states[pair.b].mesh;
        poured.energies.points += level.points[k].linearize(a, b, level.match_loss, system_);
        poured.energies.dense += level.dense[k].linearize(a, b, level.match_loss, system_);
        if (level.recipe.lines)
            poured.energies.lines += level.lines[k].linearize(a, b, level.match_loss, system_);
        if (level.recipe.pixels)
            poured.energies.photometric += level.pixels[k].linearize(states, false, level.pixel_loss, system_);
    }
    for (size_t i = 0; i < states.size(); ++i)
        if (!problem_.images[i].held)
            poured.energies.similarity += similarity_[i].linearize(states[i].mesh, system_);
    if (level.recipe.colors)
        poured.energies.color = system_.colors().regularEnergy(colorsOf(states));
    poured.rest = poured.energies.total() - poured.energies.similarity;
    return poured;
}

SolveStatus Optimizer::guardedStep(const std::vector<ImageState>& states, const std::vector<ColorGrid>& colors,
                                   MeshStep& step)
{
    SolveStatus status = SolveStatus::Solved;
    for (int attempt = 0; attempt <= MAX_STIFFENINGS; ++attempt)
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
            if (attempt < MAX_STIFFENINGS)
                for (int cell : cells)
                    similarity_[i].stiffen(cell, STIFFEN, states[i].mesh, system_);
        }
        if (!folds)
            return status;
    }
    double share = 1;
    for (size_t i = 0; i < states.size(); ++i)
        if (!problem_.images[i].held)
            share = std::min(share, guards_[i].allowed(states[i].mesh, step[i]));
    for (std::vector<Point2d>& image : step)
        for (Point2d& p : image)
            p *= share;
    return status;
}

OptimizeStatus Optimizer::runLevel(Level& level, std::vector<ImageState>& states, LevelReport& report,
                                   const std::function<bool()>& keep_going)
{
    report.scale = level.scale;
    Poured now = pour(level, states);
    if (level.recipe.colors)
    {
        // eq. initialfunction: colours first, the mesh standing still.
        std::vector<ColorGrid> colors = colorsOf(states);
        if (system_.solveColors(colors))
            for (size_t i = 0; i < states.size(); ++i)
                states[i].color = colors[i];
    }
    level.pixel_loss = RobustLoss(robustScale(level.pixels, states, params_.robustScale));
    now = pour(level, states);
    report.start = now.energies;
    report.end = now.energies;
    for (int iteration = 0; iteration < params_.maxIterations; ++iteration)
    {
        if (!keep_going())
            return OptimizeStatus::Cancelled;
        std::vector<ColorGrid> colors = colorsOf(states);
        MeshStep step;
        if (guardedStep(states, colors, step) == SolveStatus::NotPositiveDefinite)
            return OptimizeStatus::Singular;
        if (level.recipe.colors)
            system_.solveColorsAfter(step, colors);
        double before = now.rest;
        for (size_t i = 0; i < states.size(); ++i)
            before += problem_.images[i].held ? 0 : similarity_[i].energy(states[i].mesh);
        double motion = 0;
        double share = 1;
        bool accepted = false;
        for (int halving = 0; halving <= MAX_HALVINGS && !accepted; ++halving, share *= 0.5)
        {
            std::vector<ImageState> next = states;
            motion = 0;
            for (size_t i = 0; i < states.size(); ++i)
            {
                if (step[i].empty())
                    continue;
                next[i].mesh = moved(states[i].mesh, step[i], share);
                motion = std::max(motion, maxVertexDistance(next[i].mesh, states[i].mesh));
                if (level.recipe.colors)
                    next[i].color = mixed(states[i].color, colors[i], share);
            }
            now = pour(level, next);
            accepted = now.energies.total() <= before;
            if (accepted)
                states.swap(next);
        }
        ++report.iterations;
        if (!accepted)
        {
            now = pour(level, states);
            report.converged = true;
            break;
        }
        report.end = now.energies;
        if (motion < params_.stopMotion * level.scale)
        {
            report.converged = true;
            break;
        }
    }
    return OptimizeStatus::Done;
}

OptimizeStatus Optimizer::run(const Recipe& recipe, std::vector<ImageState>& states, std::vector<LevelReport>& report,
                              const StepCallback& progress)
{
    report.clear();
    if (!recipe.movesMesh())
        return OptimizeStatus::Done;
    Level level;
    level.recipe = recipe;
    level.match_loss = RobustLoss(params_.matchScale > 0 ? params_.matchScale : std::numeric_limits<double>::infinity());
    size_t levels = recipe.pixels ? static_cast<size_t>(params_.pyramidLevels) : 1;
    for (const ProblemPair& pair : problem_.pairs)
    {
        const Lattice& a = problem_.images[pair.a].rough.lattice();
        const Lattice& b = problem_.images[pair.b].rough.lattice();
        level.points.emplace_back(pair.a, pair.b, a, b, pair.matches.points, params_.geometricWeight);
        level.dense.emplace_back(pair.a, pair.b, a, b, pair.matches.dense, params_.denseWeight);
        level.lines.emplace_back(pair.a, pair.b, a, b, pair.matches.lines, params_.lineStep, params_.geometricWeight);
        if (recipe.pixels)
            levels = std::min({levels, problem_.images[pair.a].pyramid.size(), problem_.images[pair.b].pyramid.size()});
    }
    const double steps = static_cast<double>(levels) * params_.maxIterations;
    for (size_t l = levels; l-- > 0;)
    {
        level.scale = std::ldexp(1.0, static_cast<int>(l));
        level.pixels.clear();
        PhotometricTerm::Options options;
        options.step = params_.sampleStep;
        options.weight = params_.photometricWeight;
        options.contrast_floor = params_.contrastFloor;
        if (recipe.pixels)
            for (const ProblemPair& pair : problem_.pairs)
                level.pixels.emplace_back(pair.a, pair.b, problem_.images[pair.a].pyramid[l],
                                          problem_.images[pair.b].pyramid[l], states[pair.a].mesh.lattice(), options);
        // E_r of eq. initialfunction holds the quads without samples. Rebuilt per level: the overlap has changed.
        if (recipe.colors)
            setColorRest(level.pixels, states);
        double done = static_cast<double>(levels - 1 - l) * params_.maxIterations;
        LevelReport level_report;
        const OptimizeStatus status =
            runLevel(level, states, level_report, [&] { return !progress || progress(done++ / steps); });
        report.push_back(level_report);
        if (status != OptimizeStatus::Done)
            return status;
    }
    return OptimizeStatus::Done;
}

void Optimizer::setColorRest(const std::vector<PhotometricTerm>& pixels, const std::vector<ImageState>& states)
{
    std::vector<std::vector<int>> inside;
    for (const ImageState& state : states)
        inside.emplace_back(state.mesh.lattice().cellCount(), 0);
    for (const PhotometricTerm& term : pixels)
    {
        const std::vector<int> counts = term.countInside(states);
        for (size_t cell = 0; cell < counts.size(); ++cell)
            inside[term.sourceImage()][cell] += counts[cell];
    }
    system_.colors().clearPulls();
    for (size_t i = 0; i < states.size(); ++i)
        for (size_t cell = 0; cell < inside[i].size(); ++cell)
            if (inside[i][cell] == 0)
                system_.colors().addPull({static_cast<int>(i), static_cast<int>(cell)}, params_.colorRestWeight);
}

} // namespace gcpw
} // namespace cv
