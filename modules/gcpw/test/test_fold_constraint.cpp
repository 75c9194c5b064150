// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#include "test_precomp.hpp"

#include "bent_mesh.hpp"
#include "energy/similarity_term.hpp"
#include "optimization/fold_constraint.hpp"
#include "recording_equations.hpp"

namespace opencv_test { namespace {

using namespace cv::gcpw;

const Lattice LATTICE(Size(160, 120), 8, 6); // cells of 20 x 20 px, 400 px^2
const double SHARE = 0.1;

std::vector<Point2d> noStep()
{
    return std::vector<Point2d>(LATTICE.vertexCount());
}

std::vector<Point2d> randomStep(double size_px, uint64_t seed)
{
    RNG rng = seeded(seed);
    std::vector<Point2d> step = noStep();
    for (Point2d& p : step)
        p = Point2d(rng.uniform(-size_px, size_px), rng.uniform(-size_px, size_px));
    return step;
}

double leastArea(const MeshGrid& mesh)
{
    double least = 1e30;
    for (int cell = 0; cell < LATTICE.cellCount(); ++cell)
        for (int k = 0; k < 4; ++k)
            least = std::min(least, mesh.cornerArea(cell, k));
    return least;
}

TEST(Gcpw_FoldConstraint, a_step_that_changes_no_shape_is_free)
{
    const MeshGrid rough = bentMesh(LATTICE, 2, 1);
    const FoldConstraint guard(rough, SHARE);
    std::vector<Point2d> step = noStep();
    EXPECT_TRUE(guard.violated(rough, step).empty());
    for (Point2d& p : step)
        p = Point2d(1e4, -1e4);
    const std::vector<Point2d> before = step;
    EXPECT_TRUE(guard.violated(rough, step).empty());
    guard.shorten(rough, step);
    EXPECT_EQ(step, before);
}

TEST(Gcpw_FoldConstraint, a_quad_is_violated_exactly_when_a_corner_falls_below_its_share)
{
    const MeshGrid rough(LATTICE);
    const FoldConstraint guard(rough, SHARE);
    std::vector<Point2d> step = noStep();
    const int cell = 3 * 8 + 4;
    // The area at the corner opposite the moved one stays; that at the two beside it is 20 * (20 - d).
    Point2d& corner = step[LATTICE.vertexOf(cell, 3)];
    corner = Point2d(0, -17.9);
    EXPECT_TRUE(guard.violated(rough, step).empty());
    corner = Point2d(0, -18.1);
    const std::vector<int> expected = {cell, cell + 1};
    EXPECT_EQ(guard.violated(rough, step), expected);
}

TEST(Gcpw_FoldConstraint, a_step_that_is_not_a_number_violates)
{
    const MeshGrid rough(LATTICE);
    const FoldConstraint guard(rough, SHARE);
    std::vector<Point2d> step = noStep();
    step[LATTICE.vertexOf(10, 0)].x = std::numeric_limits<double>::quiet_NaN();
    EXPECT_EQ(guard.violated(rough, step).size(), 4u);
    guard.shorten(rough, step);
    EXPECT_EQ(moved(rough, step).countFolds(), 0);
}

TEST(Gcpw_FoldConstraint, a_shortened_step_violates_nothing_however_wild_it_was)
{
    const MeshGrid rough = bentMesh(LATTICE, 3, 2);
    const FoldConstraint guard(rough, SHARE);
    for (const double size : {5.0, 20.0, 100.0, 1e6})
        for (uint64_t seed = 0; seed < 10; ++seed)
        {
            std::vector<Point2d> step = randomStep(size, seed);
            guard.shorten(rough, step);
            EXPECT_TRUE(guard.violated(rough, step).empty());
            EXPECT_EQ(moved(rough, step).countFolds(), 0);
        }
}

TEST(Gcpw_FoldConstraint, many_shortened_steps_never_fold)
{
    const MeshGrid rough = bentMesh(LATTICE, 3, 3);
    const FoldConstraint guard(rough, SHARE);
    MeshGrid mesh = rough;
    for (uint64_t seed = 0; seed < 200; ++seed)
    {
        std::vector<Point2d> step = randomStep(8, seed);
        guard.shorten(mesh, step);
        mesh = moved(mesh, step);
        ASSERT_EQ(mesh.countFolds(), 0) << "step " << seed;
    }
    EXPECT_GT(maxVertexDistance(mesh, rough), 5) << "nothing moved";
    EXPECT_GT(leastArea(mesh), 0.9 * SHARE * leastArea(rough));
}

TEST(Gcpw_FoldConstraint, vertices_away_from_a_violated_quad_keep_their_step)
{
    const MeshGrid rough(LATTICE);
    const FoldConstraint guard(rough, SHARE);
    std::vector<Point2d> step(LATTICE.vertexCount(), Point2d(0.5, -0.25));
    const int wild = LATTICE.vertexOf(0, 0);
    step[wild] = Point2d(60, 60);
    guard.shorten(rough, step);
    EXPECT_LT(cv::norm(step[wild]), 40);
    EXPECT_EQ(step[LATTICE.vertexOf(3 * 8 + 5, 3)], Point2d(0.5, -0.25));
    EXPECT_EQ(step.back(), Point2d(0.5, -0.25));
}

TEST(Gcpw_FoldConstraint, a_step_that_is_legal_as_a_whole_may_be_illegal_half_way)
{
    // A turn by 150 degrees keeps every area; half of its chord leaves cos(75 deg)^2 = 6.7 % of it.
    const MeshGrid mesh(Lattice(Size(80, 60), 4, 3));
    const FoldConstraint guard(mesh, 0.1);
    const double angle = 150 * CV_PI / 180;
    std::vector<Point2d> step;
    for (const Point2d& v : mesh.vertices())
        step.push_back(Point2d(std::cos(angle) * v.x - std::sin(angle) * v.y, std::sin(angle) * v.x + std::cos(angle) * v.y) - v);
    const auto part = [&step](double share)
    {
        std::vector<Point2d> result = step;
        for (Point2d& move : result)
            move *= share;
        return result;
    };
    EXPECT_TRUE(guard.violated(mesh, step).empty());
    EXPECT_EQ(guard.violated(mesh, part(0.5)).size(), 12u);
    EXPECT_TRUE(guard.violated(mesh, part(0.125)).empty());
}

TEST(Gcpw_FoldConstraint, a_damped_quad_resists_a_step_and_has_neither_energy_nor_gradient)
{
    const Lattice lattice(Size(80, 60), 4, 3);
    const MeshGrid rough(lattice);
    const double weight = 0.5;
    FoldConstraint constraint(rough, 0.1, 0, weight);
    RecordingEquations none({lattice});
    constraint.addTo(none);
    EXPECT_TRUE(none.empty());
    RecordingEquations added({lattice});
    constraint.damp(5, added);
    const double once = added.blocks[0].block.mesh_mesh[0][0] / (weight * similarityBlock(rough, 5)[0][0]);
    constraint.damp(5, added);
    RecordingEquations all({lattice});
    constraint.addTo(all);
    ASSERT_EQ(all.blocks.size(), 1u);
    EXPECT_EQ(all.blocks[0].quad.cell, 5);
    EXPECT_EQ(all.energy(), 0);
    EXPECT_EQ(all.gradient().norm(), 0);
    EXPECT_LT((all.matrix() - added.matrix()).norm(), 1e-9 * all.matrix().norm()) << "what was added is what it has from now on";
    // Each time by the same factor.
    EXPECT_GT(once, 1);
    EXPECT_NEAR(all.blocks[0].block.mesh_mesh[0][0], ((once + 1) * (once + 1) - 1) * weight * similarityBlock(rough, 5)[0][0], 1e-9);
    constraint.relax();
    RecordingEquations relaxed({lattice});
    constraint.addTo(relaxed);
    EXPECT_TRUE(relaxed.empty());
}

}} // namespace
