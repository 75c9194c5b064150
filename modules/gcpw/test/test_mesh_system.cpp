// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#include "test_precomp.hpp"

#include <Eigen/Cholesky>
#include "solver/mesh_system.hpp"
#include "random_problem.hpp"
#include "recording_equations.hpp"

namespace opencv_test { namespace {

using namespace cv::gcpw;

const double DAMPING = 0.3;
const Lattice FIRST(Size(80, 60), 4, 3);
const Lattice SECOND(Size(50, 70), 2, 5);

/// Adds the same rows and blocks to several receivers.
class Both : public NormalEquations
{
public:
    Both(NormalEquations& one, NormalEquations& other) : one_(one), other_(other) {}

    void addRow(QuadId quad, const QuadRow& row, double residual, double weight) override
    {
        one_.addRow(quad, row, residual, weight);
        other_.addRow(quad, row, residual, weight);
    }
    void addRow(QuadId a, const QuadRow& row_a, QuadId b, const QuadRow& row_b, double residual, double weight) override
    {
        one_.addRow(a, row_a, b, row_b, residual, weight);
        other_.addRow(a, row_a, b, row_b, residual, weight);
    }
    void addBlock(QuadId quad, const QuadBlock& block, const QuadRow& gradient, double energy) override
    {
        one_.addBlock(quad, block, gradient, energy);
        other_.addBlock(quad, block, gradient, energy);
    }
    void addGroup(int image, const RowGroup& group, const std::vector<double>& residuals, double weight) override
    {
        one_.addGroup(image, group, residuals, weight);
        other_.addGroup(image, group, residuals, weight);
    }
    void addPhotometric(QuadId quad, const PhotometricBlock& block) override
    {
        one_.addPhotometric(quad, block);
        other_.addPhotometric(quad, block);
    }
    void addCross(QuadId a, QuadId b, const CrossBlock& block) override
    {
        one_.addCross(a, b, block);
        other_.addCross(a, b, block);
    }
    void addColorDifference(QuadId a, QuadId b, const ColorBlock& block) override
    {
        one_.addColorDifference(a, b, block);
        other_.addColorDifference(a, b, block);
    }
    void addColorPrior(QuadId quad, double weight, const ColorGrid::Quad& reference) override
    {
        one_.addColorPrior(quad, weight, reference);
        other_.addColorPrior(quad, weight, reference);
    }

private:
    NormalEquations& one_;
    NormalEquations& other_;
};

/// Rows of one image, blocks, and rows that tie both images.
void accumulateRandomly(NormalEquations& equations, bool tied, uint64_t seed)
{
    RNG rng = seeded(seed);
    const int cells[2] = {FIRST.cellCount(), SECOND.cellCount()};
    for (int i = 0; i < 120; ++i)
    {
        const int image = rng.uniform(0, 2);
        const QuadId quad{image, rng.uniform(0, cells[image])};
        equations.addRow(quad, randomRow(rng), rng.uniform(-1.0, 1.0), rng.uniform(0.1, 2.0));
        const PhotometricBlock block = randomPhotometricBlock(rng, 2);
        equations.addBlock({1 - image, rng.uniform(0, cells[1 - image])}, block.mesh_mesh, block.mesh_gradient,
                      block.energy);
        if (!tied)
            continue;
        const QuadId a{0, rng.uniform(0, cells[0])};
        const QuadId b{1, rng.uniform(0, cells[1])};
        equations.addRow(a, randomRow(rng), b, randomRow(rng), rng.uniform(-1.0, 1.0), rng.uniform(0.1, 2.0));
        const RandomSamples samples = randomSamples(rng, 2);
        equations.addPhotometric(b, samples.own);
        equations.addCross(b, a, samples.target);
    }
}

/// The step that a dense solver finds, over the mesh unknowns of both images; those of fixed images stay zero.
Eigen::VectorXd denseStep(const RecordingEquations& record, bool first_held, bool second_fixed)
{
    const int n = record.meshColumns();
    Eigen::MatrixXd matrix = record.matrix().topLeftCorner(n, n);
    Eigen::VectorXd right = -record.gradient().head(n);
    matrix.diagonal().array() += DAMPING;
    for (int k = 0; k < n; ++k)
        if (k < 2 * FIRST.vertexCount() ? first_held : second_fixed)
        {
            matrix.row(k).setZero();
            matrix.col(k).setZero();
            matrix(k, k) = 1;
            right[k] = 0;
        }
    return matrix.ldlt().solve(right);
}

Eigen::VectorXd stacked(const MeshStep& step)
{
    Eigen::VectorXd all = Eigen::VectorXd::Zero(2 * (FIRST.vertexCount() + SECOND.vertexCount()));
    for (int image = 0; image < 2; ++image)
        for (size_t v = 0; v < step[image].size(); ++v)
        {
            const size_t column = 2 * (v + (image ? FIRST.vertexCount() : 0));
            all[column] = step[image][v].x;
            all[column + 1] = step[image][v].y;
        }
    return all;
}

TEST(Gcpw_MeshSystem, each_image_is_solved_exactly)
{
    MeshSystem system({FIRST, SECOND}, {false, false});
    RecordingEquations record({FIRST, SECOND});
    Both both(system, record);
    system.addDamping(DAMPING);
    accumulateRandomly(both, false, 1);
    MeshStep step;
    ASSERT_EQ(system.solve(step), SolveStatus::Solved);
    const Eigen::VectorXd expected = denseStep(record, false, false);
    EXPECT_LT((stacked(step) - expected).norm(), 1e-9 * expected.norm());
}

TEST(Gcpw_MeshSystem, tied_images_are_solved_together)
{
    MeshSystem system({FIRST, SECOND}, {false, false});
    RecordingEquations record({FIRST, SECOND});
    Both both(system, record);
    system.addDamping(DAMPING);
    accumulateRandomly(both, true, 2);
    MeshStep step;
    ASSERT_EQ(system.solve(step), SolveStatus::Solved);
    const Eigen::VectorXd expected = denseStep(record, false, false);
    EXPECT_LT((stacked(step) - expected).norm(), 2e-3 * expected.norm());
    // The ties matter, or this says nothing.
    RecordingEquations loose({FIRST, SECOND});
    accumulateRandomly(loose, false, 2);
    EXPECT_GT((denseStep(loose, false, false) - expected).norm(), 0.1 * expected.norm());
}

/// Nine rows of one image that share two unknowns.
RowGroup randomGroup(RNG& rng, const Lattice& lattice)
{
    std::vector<GroupRow> rows(9);
    for (GroupRow& row : rows)
    {
        row.cell = rng.uniform(0, lattice.cellCount());
        row.row = randomRow(rng);
        row.shared = {{1, rng.uniform(-1.0, 1.0)}};
    }
    return RowGroup(lattice, rows);
}

std::vector<double> randomResiduals(RNG& rng, const RowGroup& group)
{
    std::vector<double> residuals(group.rows().size());
    for (double& residual : residuals)
        residual = rng.uniform(-1.0, 1.0);
    group.project(residuals);
    return residuals;
}

TEST(Gcpw_MeshSystem, unknowns_that_a_group_of_rows_shares_are_eliminated_exactly)
{
    for (const bool tied : {false, true})
    {
        MeshSystem system({FIRST, SECOND}, {false, false});
        RecordingEquations record({FIRST, SECOND});
        Both both(system, record);
        system.addDamping(DAMPING);
        accumulateRandomly(both, tied, 5);
        const Eigen::VectorXd before = denseStep(record, false, false);
        RNG rng = seeded(6);
        for (int k = 0; k < 6; ++k)
        {
            const RowGroup group = randomGroup(rng, k % 2 ? SECOND : FIRST);
            both.addGroup(k % 2, group, randomResiduals(rng, group), 20);
        }
        MeshStep step;
        ASSERT_EQ(system.solve(step, 1e-8), SolveStatus::Solved);
        const Eigen::VectorXd expected = denseStep(record, false, false);
        EXPECT_LT((stacked(step) - expected).norm(), 1e-5 * expected.norm());
        EXPECT_GT((before - expected).norm(), 0.05 * expected.norm()) << "the groups matter, or this says nothing";
    }
}

TEST(Gcpw_MeshSystem, a_group_resists_nothing_that_its_own_unknowns_follow)
{
    RNG rng = seeded(7);
    MeshSystem system({FIRST, SECOND}, {false, false});
    const RowGroup group = randomGroup(rng, FIRST);
    std::vector<double> residuals;
    for (const GroupRow& row : group.rows())
        residuals.push_back(3 * row.shared[0] - 5 * row.shared[1]);
    EXPECT_LT(group.project(residuals), 1e-20);
    system.addDamping(DAMPING);
    system.addGroup(0, group, residuals, 1e6);
    MeshStep step;
    ASSERT_EQ(system.solve(step), SolveStatus::Solved);
    EXPECT_LT(stacked(step).norm(), 1e-6);
}

TEST(Gcpw_MeshSystem, setZero_forgets_groups)
{
    RNG rng = seeded(8);
    MeshSystem system({FIRST, SECOND}, {false, false});
    const RowGroup group = randomGroup(rng, FIRST);
    system.addGroup(0, group, randomResiduals(rng, group), 10);
    system.setZero();
    system.addDamping(DAMPING);
    MeshStep step;
    ASSERT_EQ(system.solve(step), SolveStatus::Solved);
    EXPECT_EQ(stacked(step).norm(), 0);
}

TEST(Gcpw_MeshSystem, both_sides_of_samples_tie_as_two_sided_rows_do)
{
    RNG rng = seeded(3);
    const QuadId a{0, 5};
    const QuadId b{1, 3};
    const QuadRow row_a = randomRow(rng);
    const QuadRow row_b = randomRow(rng);
    PhotometricBlock own;
    CrossBlock target;
    for (int i = 0; i < 8; ++i)
    {
        own.mesh_gradient[i] = 1.3 * 0.7 * row_a[i];
        target.mesh_gradient[i] = 1.3 * 0.7 * row_b[i];
        for (int j = 0; j < 8; ++j)
        {
            own.mesh_mesh[i][j] = 1.3 * row_a[i] * row_a[j];
            target.mesh_mesh[i][j] = 1.3 * row_b[i] * row_b[j];
            target.cross[i][j] = 1.3 * row_a[i] * row_b[j];
        }
    }
    MeshSystem by_row({FIRST, SECOND}, {false, false});
    MeshSystem by_block({FIRST, SECOND}, {false, false});
    by_row.addRow(a, row_a, b, row_b, 0.7, 1.3);
    by_block.addPhotometric(a, own);
    by_block.addCross(a, b, target);
    MeshStep steps[2];
    by_row.addDamping(DAMPING);
    by_block.addDamping(DAMPING);
    ASSERT_EQ(by_row.solve(steps[0]), SolveStatus::Solved);
    ASSERT_EQ(by_block.solve(steps[1]), SolveStatus::Solved);
    EXPECT_GT(stacked(steps[0]).norm(), 0.01);
    EXPECT_LT((stacked(steps[0]) - stacked(steps[1])).norm(), 1e-9);
}

TEST(Gcpw_MeshSystem, a_fixed_image_does_not_move_and_the_other_moves_as_if_alone)
{
    for (const bool first_held : {true, false})
    {
        MeshSystem system({FIRST, SECOND}, {first_held, !first_held});
        RecordingEquations record({FIRST, SECOND});
        Both both(system, record);
        system.addDamping(DAMPING);
        accumulateRandomly(both, true, 4);
        MeshStep step;
        ASSERT_EQ(system.solve(step), SolveStatus::Solved);
        EXPECT_TRUE(step[first_held ? 0 : 1].empty());
        const Eigen::VectorXd expected = denseStep(record, first_held, !first_held);
        EXPECT_LT((stacked(step) - expected).norm(), 1e-9 * expected.norm());
    }
}

TEST(Gcpw_MeshSystem, the_mesh_part_of_a_colored_block_is_a_block)
{
    RNG rng = seeded(5);
    const PhotometricBlock block = randomPhotometricBlock(rng, 4);
    MeshSystem systems[2] = {{{FIRST, SECOND}, {false, true}}, {{FIRST, SECOND}, {false, true}}};
    systems[0].addPhotometric({0, 4}, block);
    systems[1].addBlock({0, 4}, block.mesh_mesh, block.mesh_gradient, block.energy);
    MeshStep steps[2];
    for (int i = 0; i < 2; ++i)
    {
        systems[i].addDamping(DAMPING);
        ASSERT_EQ(systems[i].solve(steps[i]), SolveStatus::Solved);
    }
    EXPECT_GT(stacked(steps[0]).norm(), 0.01);
    EXPECT_EQ(stacked(steps[0]), stacked(steps[1]));
}

TEST(Gcpw_MeshSystem, blocks_may_be_added_after_a_solve)
{
    MeshSystem at_once({FIRST, SECOND}, {false, false});
    MeshSystem in_turn({FIRST, SECOND}, {false, false});
    MeshStep steps[2];
    for (MeshSystem* system : {&at_once, &in_turn})
    {
        system->addDamping(DAMPING);
        accumulateRandomly(*system, false, 6);
    }
    ASSERT_EQ(in_turn.solve(steps[1]), SolveStatus::Solved);
    for (MeshSystem* system : {&at_once, &in_turn})
        accumulateRandomly(*system, false, 7);
    ASSERT_EQ(at_once.solve(steps[0]), SolveStatus::Solved);
    ASSERT_EQ(in_turn.solve(steps[1]), SolveStatus::Solved);
    EXPECT_EQ(stacked(steps[0]), stacked(steps[1]));
}

TEST(Gcpw_MeshSystem, set_to_zero_it_forgets)
{
    MeshSystem system({FIRST, SECOND}, {false, false});
    accumulateRandomly(system, true, 8);
    system.addDamping(7);
    system.setZero();
    system.addDamping(1);
    MeshStep step;
    ASSERT_EQ(system.solve(step), SolveStatus::Solved);
    EXPECT_EQ(stacked(step).norm(), 0);
}

TEST(Gcpw_MeshSystem, a_motion_that_nothing_holds_or_that_is_not_a_number_is_refused)
{
    MeshSystem system({FIRST, SECOND}, {false, true});
    MeshStep step;
    EXPECT_EQ(system.solve(step), SolveStatus::NotPositiveDefinite) << "nothing was accumulated";
    RNG rng = seeded(9);
    const QuadRow row = randomRow(rng);
    system.addRow({0, 3}, row, 1, 1);
    EXPECT_EQ(system.solve(step), SolveStatus::NotPositiveDefinite) << "one row constrains one motion";
    system.addDamping(1);
    EXPECT_EQ(system.solve(step), SolveStatus::Solved);
    const double nan = std::numeric_limits<double>::quiet_NaN();
    system.addRow({0, 3}, row, nan, 1);
    EXPECT_EQ(system.solve(step), SolveStatus::NotPositiveDefinite) << "a residual that is not a number";
    system.setZero();
    system.addDamping(1);
    system.addRow({0, 3}, row, 1, nan);
    EXPECT_EQ(system.solve(step), SolveStatus::NotPositiveDefinite) << "a weight that is not a number";
}

TEST(Gcpw_MeshSystem, there_is_a_flag_for_every_lattice)
{
    EXPECT_THROW(MeshSystem({FIRST, SECOND}, {false}), cv::Exception);
}

}} // namespace
