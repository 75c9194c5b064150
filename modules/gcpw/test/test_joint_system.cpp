// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#include "test_precomp.hpp"

#include <Eigen/Cholesky>
#include "solver/joint_system.hpp"
#include "random_problem.hpp"
#include "recording_equations.hpp"
#include "energy/color_smoothness_term.hpp"

namespace opencv_test { namespace {

using namespace cv::gcpw;

const Lattice LATTICE(Size(60, 60), 3, 3);
const double DAMPING = 1e-6;
const double SMOOTHNESS = 0.5;

/// A quadratic energy of all unknowns of one image: what every quad says at any state, from its random form.
class Quadratic
{
public:
    explicit Quadratic(uint64_t seed) : record_({LATTICE})
    {
        RNG rng = seeded(seed);
        for (int cell = 0; cell < LATTICE.cellCount(); ++cell)
            record_.addPhotometric({0, cell}, randomPhotometricBlock(rng, 30));
    }

    int unknowns() const { return record_.columns(); }

    /// Accumulates the blocks at the displacement `x` of all unknowns from the start (colours start at the identity).
    void accumulate(const Eigen::VectorXd& x, NormalEquations& equations) const
    {
        for (const RecordingEquations::Block& item : record_.blocks)
        {
            RecordingEquations one({LATTICE});
            one.addPhotometric(item.quad, item.block);
            const Eigen::VectorXd moved = one.gradient() + one.matrix() * x;
            PhotometricBlock block = item.block;
            for (int k = 0; k < 8; ++k)
                block.mesh_gradient[k] = moved[one.meshColumn(item.quad, k)];
            for (int k = 0; k < 6; ++k)
                block.color_gradient[k / 2][k % 2] = moved[one.colorColumn(item.quad, k)];
            equations.addPhotometric(item.quad, block);
        }
    }

    /// The minimum over meshes and colours at once, by a dense factorisation.
    Eigen::VectorXd minimum() const
    {
        Eigen::MatrixXd matrix = record_.matrix() + smoothness();
        matrix.topLeftCorner(record_.meshColumns(), record_.meshColumns()).diagonal().array() += 1e-9;
        return matrix.ldlt().solve(-record_.gradient());
    }

    double energy(const Eigen::VectorXd& x) const
    {
        return record_.energy() + 2 * record_.gradient().dot(x) + x.dot((record_.matrix() + smoothness()) * x);
    }

private:
    Eigen::MatrixXd smoothness() const
    {
        Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(unknowns(), unknowns());
        std::array<int, 8> near;
        for (int cell = 0; cell < LATTICE.cellCount(); ++cell)
            for (int n = 0, count = LATTICE.neighbours(cell, near); n < count; ++n)
                for (int c = 0; c < 3; ++c)
                    for (int i = 0; i <= 10; ++i)
                    {
                        Eigen::VectorXd row = Eigen::VectorXd::Zero(unknowns());
                        for (int sign : {1, -1})
                        {
                            const QuadId quad{0, sign > 0 ? cell : near[n]};
                            row[record_.colorColumn(quad, 2 * c)] = sign * 0.1 * i;
                            row[record_.colorColumn(quad, 2 * c + 1)] = sign;
                        }
                        matrix += SMOOTHNESS * row * row.transpose();
                    }
        return matrix;
    }

    RecordingEquations record_;
};

struct Displaced
{
    std::vector<ColorGrid> colors{ColorGrid(LATTICE)};
    std::vector<Point2d> mesh = std::vector<Point2d>(LATTICE.vertexCount());

    Eigen::VectorXd stacked() const
    {
        std::vector<double> all;
        for (const Point2d& v : mesh)
            all.insert(all.end(), {v.x, v.y});
        for (int cell = 0; cell < LATTICE.cellCount(); ++cell)
            for (const ChannelAffine& map : colors[0].quad(cell))
                all.insert(all.end(), {map.gain - 1, map.bias});
        return Eigen::Map<Eigen::VectorXd>(all.data(), static_cast<Eigen::Index>(all.size()));
    }
};

TEST(Gcpw_JointSystem, repeated_steps_reach_the_minimum_of_all_unknowns_together)
{
    const Quadratic problem(1);
    JointSystem system({LATTICE}, {false}, {false});
    Displaced state;
    const Eigen::VectorXd best = problem.minimum();
    double energy = problem.energy(state.stacked());
    const double lowest = problem.energy(best);
    const double first_gap = energy - lowest;
    for (int step_count = 0; step_count < 12; ++step_count)
    {
        system.setZero();
        system.addDamping(DAMPING);
        ColorSmoothnessTerm(0, LATTICE, SMOOTHNESS).addTo(system);
        problem.accumulate(state.stacked(), system);
        MeshStep step;
        ASSERT_EQ(system.solveMeshes(state.colors, step), SolveStatus::Solved);
        ASSERT_EQ(system.solveColorsAfter(step, state.colors), SolveStatus::Solved);
        for (int v = 0; v < LATTICE.vertexCount(); ++v)
            state.mesh[v] += step[0][v];
        const double next = problem.energy(state.stacked());
        EXPECT_LE(next, energy + 1e-9) << "step " << step_count;
        if (step_count == 0)
        {
            EXPECT_LT(next - lowest, 0.2 * first_gap);
        }
        energy = next;
    }
    EXPECT_GT(first_gap, 0.1);
    EXPECT_LT(energy - lowest, 1e-3 * first_gap);
}

TEST(Gcpw_JointSystem, colors_alone_are_best_while_the_mesh_stands_still)
{
    const Quadratic problem(2);
    JointSystem system({LATTICE}, {false}, {false});
    ColorSmoothnessTerm(0, LATTICE, SMOOTHNESS).addTo(system);
    Displaced state;
    problem.accumulate(state.stacked(), system);
    ASSERT_EQ(system.solveColors(state.colors), SolveStatus::Solved);
    const Eigen::VectorXd x = state.stacked();
    const double energy = problem.energy(x);
    RNG rng = seeded(3);
    for (int i = 0; i < 50; ++i)
    {
        Eigen::VectorXd other = x;
        other[2 * LATTICE.vertexCount() + rng.uniform(0, 6 * LATTICE.cellCount())] += rng.uniform(-0.05, 0.05);
        EXPECT_GE(problem.energy(other), energy - 1e-9);
    }
    EXPECT_EQ(x.head(2 * LATTICE.vertexCount()).norm(), 0);
}

TEST(Gcpw_JointSystem, fixed_colors_leave_the_mesh_step_of_the_mesh_alone)
{
    const Quadratic problem(4);
    JointSystem joint({LATTICE}, {false}, {true});
    MeshSystem meshes({LATTICE}, {false});
    Displaced state;
    joint.addDamping(DAMPING);
    meshes.addDamping(DAMPING);
    problem.accumulate(state.stacked(), joint);
    problem.accumulate(state.stacked(), meshes);
    MeshStep steps[2];
    ASSERT_EQ(joint.solveMeshes(state.colors, steps[0]), SolveStatus::Solved);
    ASSERT_EQ(meshes.solve(steps[1]), SolveStatus::Solved);
    EXPECT_EQ(steps[0], steps[1]);
}

TEST(Gcpw_JointSystem, a_second_solve_after_further_blocks_eliminates_once)
{
    const Quadratic problem(5);
    JointSystem systems[2] = {{{LATTICE}, {false}, {false}}, {{LATTICE}, {false}, {false}}};
    RNG rng = seeded(6);
    const PhotometricBlock more = randomPhotometricBlock(rng, 5);
    MeshStep steps[2];
    const Displaced state;
    for (int i = 0; i < 2; ++i)
    {
        ColorSmoothnessTerm(0, LATTICE, SMOOTHNESS).addTo(systems[i]);
        systems[i].addDamping(DAMPING);
        problem.accumulate(state.stacked(), systems[i]);
        if (i == 1)
        {
            ASSERT_EQ(systems[i].solveMeshes(state.colors, steps[i]), SolveStatus::Solved);
        }
        systems[i].addBlock({0, 4}, more.mesh_mesh, more.mesh_gradient, more.energy);
        ASSERT_EQ(systems[i].solveMeshes(state.colors, steps[i]), SolveStatus::Solved);
    }
    for (int v = 0; v < LATTICE.vertexCount(); ++v)
        EXPECT_LT(cv::norm(steps[0][0][v] - steps[1][0][v]), 1e-9);
}

TEST(Gcpw_JointSystem, set_to_zero_it_forgets_everything)
{
    const Quadratic problem(7);
    JointSystem system({LATTICE}, {false}, {false});
    ColorSmoothnessTerm(0, LATTICE, SMOOTHNESS).addTo(system);
    Displaced state;
    problem.accumulate(Displaced().stacked(), system);
    system.setZero();
    system.addDamping(1);
    MeshStep step;
    ASSERT_EQ(system.solveMeshes(state.colors, step), SolveStatus::Solved);
    for (const Point2d& v : step[0])
        EXPECT_EQ(v, Point2d(0, 0));
    EXPECT_EQ(system.solveColors(state.colors), SolveStatus::NotPositiveDefinite) << "neither samples nor smoothness are left";
}

}} // namespace
