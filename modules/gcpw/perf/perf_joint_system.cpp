// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#include "perf_precomp.hpp"

#include "solver/joint_system.hpp"
#include "pair_problem.hpp"
#include "sparse_reference.hpp"
#include "energy/color_smoothness_term.hpp"
#include "thread_count.hpp"

namespace opencv_test { namespace {

const double DAMPING = 1e-4; // of a vertex step, as in the optimiser

/// Step of the vertices, then change of the colours.
Eigen::VectorXd stacked(const gcpw::MeshStep& step, const gcpw::ColorGrid& before, const gcpw::ColorGrid& after)
{
    std::vector<double> all;
    for (const Point2d& vertex : step[0])
        all.insert(all.end(), {vertex.x, vertex.y});
    for (int cell = 0; cell < after.lattice().cellCount(); ++cell)
        for (int c = 0; c < gcpw::CHANNELS; ++c)
        {
            const gcpw::ChannelAffine& now = after.quad(cell)[c];
            const gcpw::ChannelAffine& was = before.quad(cell)[c];
            all.insert(all.end(), {now.gain - was.gain, now.bias - was.bias});
        }
    return Eigen::Map<Eigen::VectorXd>(all.data(), static_cast<Eigen::Index>(all.size()));
}

PERF_TEST(Gcpw_JointSystem, step_of_mesh_and_colors)
{
    const ThreadCount threads(1);
    const PairProblem problem(false);
    gcpw::JointSystem system(problem.lattices(), problem.fixed(), problem.fixed());
    const gcpw::ColorSmoothnessTerm smoothness(0, problem.lattices()[0], gcpw::Params().colorSmoothnessWeight);
    const std::vector<gcpw::ColorGrid> start{problem.states()[0].color};
    std::vector<gcpw::ColorGrid> colors;
    gcpw::MeshStep step;
    bool solved = true;
    TEST_CYCLE()
    {
        colors = start;
        system.setZero();
        system.addDamping(DAMPING);
        smoothness.addTo(system);
        problem.accumulate(system);
        solved = system.solveMeshes(colors, step) == gcpw::SolveStatus::Solved && solved;
        solved = system.solveColorsAfter(step, colors) == gcpw::SolveStatus::Solved && solved;
    }
    SparseReference reference(problem, SparseReference::MESHES_AND_COLORS, DAMPING);
    Eigen::VectorXd exact;
    CV_Assert(solved && reference.solve(exact));
    // Neighbours are fixed while colours are eliminated: not the whole gain of the exact step, but nearly.
    CV_Assert(reference.energy(stacked(step, start[0], colors[0])) <= 0.95 * reference.energy(exact));
    SANITY_CHECK_NOTHING();
}

PERF_TEST(Gcpw_JointSystem, sparse_factor_of_all_unknowns)
{
    const PairProblem problem(false);
    SparseReference reference(problem, SparseReference::MESHES_AND_COLORS, DAMPING);
    CV_Assert(reference.unknowns() == 8322);
    Eigen::VectorXd step;
    TEST_CYCLE() reference.solve(step);
    CV_Assert(reference.solve(step));
    SANITY_CHECK_NOTHING();
}

}} // namespace
