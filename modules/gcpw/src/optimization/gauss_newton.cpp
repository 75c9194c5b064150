// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#include "optimization/gauss_newton.hpp"

#include <algorithm>

namespace cv
{
namespace gcpw
{

namespace
{

const double DAMPING = 1e-4;   ///< weight of a vertex step, px^2: keeps meshes finite that no term constrains
const int MAX_STIFFENINGS = 3; ///< per step; then the step is shortened at the quads it would fold
const int MAX_HALVINGS = 4;    ///< of a step that raises the energy; then the run ends

std::vector<Lattice> latticesOf(const Problem& problem)
{
    std::vector<Lattice> lattices;
    lattices.reserve(problem.images.size());
    for (const ProblemImage& image : problem.images)
        lattices.push_back(image.rough.lattice());
    return lattices;
}

std::vector<bool> fixedOf(const Problem& problem, bool all)
{
    std::vector<bool> fixed;
    for (const ProblemImage& image : problem.images)
        fixed.push_back(all || image.fixed);
    return fixed;
}

std::vector<ColorGrid> colorsOf(const State& state)
{
    std::vector<ColorGrid> colors;
    colors.reserve(state.size());
    for (const ImageState& image : state)
        colors.push_back(image.color);
    return colors;
}

} // namespace

GaussNewton::GaussNewton(const Problem& problem, const Params& params, bool colors)
    : problem_(problem), colors_(colors), system_(latticesOf(problem), fixedOf(problem, false), fixedOf(problem, !colors))
{
    for (size_t i = 0; i < problem.images.size(); ++i)
        constraints_.emplace_back(problem.images[i].rough, params.minQuadArea, static_cast<int>(i), params.similarityWeight);
}

std::vector<TermEnergy> GaussNewton::linearize(Energy& energy, const State& state)
{
    system_.setZero();
    system_.addDamping(DAMPING);
    for (const FoldConstraint& constraint : constraints_)
        constraint.addTo(system_);
    return energy.linearize(state, system_);
}

SolveStatus GaussNewton::solveColors(Energy& energy, State& state)
{
    std::vector<ColorGrid> colors = colorsOf(state);
    linearize(energy, state);
    const SolveStatus status = system_.solveColors(colors);
    // NotConverged is an answer: the colours are then better than before.
    for (size_t i = 0; status != SolveStatus::NotPositiveDefinite && i < state.size(); ++i)
        state[i].color = colors[i];
    return status;
}

/// A step that folds little, or nothing: quads that it would fold have been made stiffer a few times.
SolveStatus GaussNewton::stiffenedStep(const State& state, MeshStep& step)
{
    const std::vector<ColorGrid> colors = colorsOf(state);
    for (int attempt = 0;; ++attempt)
    {
        const SolveStatus status = system_.solveMeshes(colors, step);
        if (status == SolveStatus::NotPositiveDefinite || attempt == MAX_STIFFENINGS)
            return status;
        bool any = false;
        for (size_t i = 0; i < state.size(); ++i)
        {
            if (problem_.images[i].fixed)
                continue;
            const std::vector<int> cells = constraints_[i].violated(state[i].mesh, step[i]);
            any = any || !cells.empty();
            for (int cell : cells)
                constraints_[i].damp(cell, system_);
        }
        if (!any)
            return status;
    }
}

/// Part of a step, shortened further at the quads that it would fold.
MeshStep GaussNewton::foldFree(const State& state, const MeshStep& step, double length) const
{
    MeshStep part = step;
    for (size_t i = 0; i < state.size(); ++i)
    {
        for (Point2d& move : part[i])
            move *= length;
        if (!problem_.images[i].fixed)
            constraints_[i].shorten(state[i].mesh, part[i]);
    }
    return part;
}

/// The longest of a few lengths of a step that does not raise the energy; false if there is none. `whole` is foldFree() of all of it.
bool GaussNewton::search(const Energy& energy, const MeshStep& step, const MeshStep& whole,
                         const std::vector<ColorGrid>& colors, double before, State& state,
                         std::vector<TermEnergy>& found, double& motion) const
{
    double length = 1;
    for (int halving = 0; halving <= MAX_HALVINGS; ++halving, length *= 0.5)
    {
        const MeshStep part = halving == 0 ? whole : foldFree(state, step, length);
        State next = state;
        motion = 0;
        for (size_t i = 0; i < state.size(); ++i)
        {
            if (problem_.images[i].fixed)
                continue;
            next[i].mesh = moved(state[i].mesh, part[i]);
            motion = std::max(motion, maxVertexDistance(next[i].mesh, state[i].mesh));
            if (colors_)
                next[i].color = mixed(state[i].color, colors[i], length);
        }
        found = energy.evaluate(next);
        if (totalEnergy(found) <= before)
        {
            state.swap(next);
            return true;
        }
    }
    return false;
}

GaussNewton::End GaussNewton::run(Energy& energy, State& state, const Rules& rules, LevelReport& report)
{
    for (FoldConstraint& constraint : constraints_)
        constraint.relax();
    report.iterations = 0;
    report.start = report.end = linearize(energy, state);
    double before = totalEnergy(report.start);
    while (true)
    {
        report.stop = StopReason::ITERATION_LIMIT;
        if (report.iterations == rules.max_iterations)
            return End::Done;
        report.stop = StopReason::CANCELLED;
        if (rules.progress && !rules.progress())
            return End::Cancelled;
        report.stop = StopReason::SINGULAR;
        MeshStep step;
        std::vector<ColorGrid> colors = colorsOf(state);
        // NotConverged is an answer here: conjugate gradients from zero lower the energy with every iteration, and the line
        // search checks the step.
        if (stiffenedStep(state, step) == SolveStatus::NotPositiveDefinite)
            return End::Singular;
        const MeshStep whole = foldFree(state, step, 1);
        if (rules.colors && system_.solveColorsAfter(whole, colors) == SolveStatus::NotPositiveDefinite)
            return End::Singular;
        ++report.iterations;
        report.stop = StopReason::NO_DESCENT;
        std::vector<TermEnergy> found;
        double motion = 0;
        if (!search(energy, step, whole, colors, before, state, found, motion))
            return End::Done;
        report.end = found;
        report.stop = StopReason::MESH_STABLE;
        if (motion < rules.stop_motion_px)
            return End::Done;
        report.stop = StopReason::ENERGY_STABLE;
        if (before - totalEnergy(found) < rules.stop_gain * before)
            return End::Done;
        before = totalEnergy(linearize(energy, state));
    }
}

} // namespace gcpw
} // namespace cv
