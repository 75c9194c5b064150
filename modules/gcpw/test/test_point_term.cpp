// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#include "test_precomp.hpp"

#include "bent_mesh.hpp"
#include "solver/mesh_system.hpp"
#include "term_laws.hpp"
#include "energy/point_term.hpp"

namespace opencv_test { namespace {

using namespace cv::gcpw;

const Lattice MOVING(Size(80, 60), 4, 3);
const Lattice TARGET(Size(100, 80), 5, 4);

TermState bentState()
{
    return TermState({bentMesh(MOVING, 3, 1, Point2d(10, 8)), bentMesh(TARGET, 3, 2)});
}

/// Matches that a state fulfils, moved apart by up to `error_px`.
std::vector<PointMatch> matchesOf(const TermState& state, int count, double error_px, uint64_t seed)
{
    RNG rng = seeded(seed);
    std::vector<PointMatch> matches;
    int hint = -1;
    while (static_cast<int>(matches.size()) < count)
    {
        PointMatch match;
        match.a = Point2d(rng.uniform(0.0, 79.0), rng.uniform(0.0, 59.0));
        const Point2d error(rng.uniform(-error_px, error_px), rng.uniform(-error_px, error_px));
        CellPoint target;
        if (!state.meshes[1].invert(state.meshes[0].warp(match.a) + error, hint, target))
            continue;
        match.b = TARGET.referencePoint(target);
        match.weight = rng.uniform(0.5, 2.0);
        matches.push_back(match);
    }
    return matches;
}

LinearizeTerm accumulatePoints(const std::vector<PointMatch>& matches, double weight, const RobustLoss& loss = RobustLoss())
{
    return linearizing(std::make_shared<PointTerm>(0, 1, MOVING, TARGET, matches, weight, loss));
}

TEST(Gcpw_PointTerm, it_is_zero_at_the_truth)
{
    const TermState truth = bentState();
    RecordingEquations equations(truth.lattices());
    EXPECT_NEAR(accumulatePoints(matchesOf(truth, 30, 0, 3), 2)(truth, equations), 0, 1e-15);
    EXPECT_EQ(equations.rows.size(), 60u);
    EXPECT_LT(equations.gradient().norm(), 1e-6);
}

TEST(Gcpw_PointTerm, its_energy_is_the_weighted_sum_of_squared_distances)
{
    const TermState state = bentState();
    const std::vector<PointMatch> matches = matchesOf(state, 30, 5, 4);
    double expected = 0;
    for (const PointMatch& match : matches)
    {
        const Point2d r = state.meshes[0].warp(match.a) - state.meshes[1].warp(match.b);
        expected += 2 * match.weight * r.dot(r);
    }
    RecordingEquations equations(state.lattices());
    EXPECT_NEAR(accumulatePoints(matches, 2)(state, equations), expected, 1e-9 * expected);
}

TEST(Gcpw_PointTerm, energy_equals_the_sum_of_squared_rows)
{
    const TermState state = bentState();
    expectEnergyIsSumOfRows(accumulatePoints(matchesOf(state, 30, 5, 5), 2), state);
}

TEST(Gcpw_PointTerm, jacobian_equals_finite_differences)
{
    const TermState state = bentState();
    const int all = 2 * (MOVING.vertexCount() + TARGET.vertexCount());
    const LinearizeTerm accumulate = accumulatePoints(matchesOf(state, 30, 5, 6), 2);
    expectExactlyQuadratic(accumulate, state, 0, all, 2.0, 1e-9);
    expectGradientIsSlope(accumulate, state, 0, all, 1e-3, 1e-7);
}

TEST(Gcpw_PointTerm, a_robust_gradient_is_the_slope_of_the_robust_energy)
{
    const TermState state = bentState();
    const int all = 2 * (MOVING.vertexCount() + TARGET.vertexCount());
    expectGradientIsSlope(accumulatePoints(matchesOf(state, 30, 5, 7), 2, RobustLoss(2)), state, 0, all, 1e-4, 1e-6);
}

TEST(Gcpw_PointTerm, moving_both_images_alike_changes_nothing)
{
    const TermState state = bentState();
    TermState shifted = state;
    for (MeshGrid& mesh : shifted.meshes)
        mesh = affineMesh(mesh, Matx22d::eye(), Point2d(13, -9));
    const LinearizeTerm accumulate = accumulatePoints(matchesOf(state, 30, 5, 8), 2);
    RecordingEquations one(state.lattices());
    RecordingEquations other(state.lattices());
    EXPECT_NEAR(accumulate(state, one), accumulate(shifted, other), 1e-9);
    // Nor do the rows feel it to first order.
    for (const RecordingEquations::Row& row : one.rows)
    {
        double sum = 0;
        for (int k = 0; k < 8; ++k)
            sum += row.row_a[k] + row.row_b[k];
        EXPECT_NEAR(sum, 0, 1e-12);
    }
}

TEST(Gcpw_PointTerm, distances_are_those_on_the_canvas_in_the_order_given)
{
    const TermState state = bentState();
    const std::vector<PointMatch> matches = matchesOf(state, 10, 5, 9);
    const std::vector<double> distances =
        PointTerm(0, 1, MOVING, TARGET, matches, 1).distances(state.state());
    ASSERT_EQ(distances.size(), matches.size());
    for (size_t i = 0; i < matches.size(); ++i)
        EXPECT_NEAR(distances[i], cv::norm(state.meshes[0].warp(matches[i].a) - state.meshes[1].warp(matches[i].b)),
                    1e-9);
}

TEST(Gcpw_PointTerm, without_matches_there_are_no_rows)
{
    const TermState state = bentState();
    RecordingEquations equations(state.lattices());
    EXPECT_EQ(accumulatePoints({}, 2)(state, equations), 0);
    EXPECT_TRUE(equations.empty());
}

TEST(Gcpw_PointTerm, a_point_outside_its_image_gives_no_rows)
{
    const TermState state = bentState();
    std::vector<PointMatch> matches(3);
    matches[0].a = Point2d(-3, 10);
    matches[0].b = Point2d(20, 20);
    matches[1].a = Point2d(10, 10);
    matches[1].b = Point2d(20, 90);
    matches[2].a = Point2d(std::numeric_limits<double>::quiet_NaN(), 10);
    matches[2].b = Point2d(20, 20);
    RecordingEquations equations(state.lattices());
    EXPECT_EQ(accumulatePoints(matches, 2)(state, equations), 0);
    EXPECT_TRUE(equations.empty());
}

TEST(Gcpw_PointTerm, a_weight_that_is_none_gives_no_rows)
{
    const TermState state = bentState();
    std::vector<PointMatch> matches = matchesOf(state, 3, 5, 10);
    matches[0].weight = std::numeric_limits<double>::quiet_NaN();
    matches[1].weight = std::numeric_limits<double>::infinity();
    matches[2].weight = -1;
    RecordingEquations equations(state.lattices());
    EXPECT_EQ(accumulatePoints(matches, 2)(state, equations), 0);
    EXPECT_TRUE(equations.empty());
}

TEST(Gcpw_PointTerm, a_state_that_is_not_a_number_is_refused_by_the_solver)
{
    TermState state = bentState();
    const LinearizeTerm accumulate = accumulatePoints(matchesOf(state, 30, 5, 10), 2);
    MeshSystem system(state.lattices(), {false, true});
    system.addDamping(1);
    MeshStep step;
    accumulate(state, system);
    EXPECT_EQ(system.solve(step), SolveStatus::Solved);
    for (Point2d& vertex : state.meshes[0].vertices())
        vertex.x = std::numeric_limits<double>::quiet_NaN();
    accumulate(state, system);
    EXPECT_EQ(system.solve(step), SolveStatus::NotPositiveDefinite);
}

}} // namespace
