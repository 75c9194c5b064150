// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#include "test_precomp.hpp"

#include "bent_mesh.hpp"
#include "term_laws.hpp"
#include "energy/line_term.hpp"

namespace opencv_test { namespace {

using namespace cv::gcpw;

const Lattice MOVING(Size(80, 60), 4, 3);
const Lattice TARGET(Size(100, 80), 5, 4);
const double STEP = 5;
const int MOVING_COLUMNS = 2 * MOVING.vertexCount();

/// An affine moving mesh over an undeformed target: straight lines stay straight.
TermState affineState()
{
    return TermState({affineMesh(MeshGrid(MOVING), Matx22d(1.1, 0.1, -0.05, 0.95), Point2d(6, 9)), MeshGrid(TARGET)});
}

TermState bentState()
{
    return TermState({bentMesh(MOVING, 3, 1, Point2d(6, 9)), bentMesh(TARGET, 3, 2)});
}

/// Segments of the moving image and pieces of the lines they come to lie on, moved aside by up to `error_px`.
std::vector<LineMatch> matchesOf(const TermState& state, int count, double error_px, uint64_t seed)
{
    RNG rng = seeded(seed);
    std::vector<LineMatch> matches(count);
    for (LineMatch& match : matches)
    {
        match.a.start = Point2d(rng.uniform(5.0, 70.0), rng.uniform(5.0, 50.0));
        match.a.end = Point2d(rng.uniform(5.0, 70.0), rng.uniform(5.0, 50.0));
        const Segment there{state.meshes[0].warp(match.a.start), state.meshes[0].warp(match.a.end)};
        const Point2d aside = rng.uniform(-error_px, error_px) * there.line().normal;
        match.b = {there.at(0.1) + aside, there.at(0.8) + aside};
        match.weight = rng.uniform(0.5, 2.0);
    }
    return matches;
}

LinearizeTerm accumulateLines(const std::vector<LineMatch>& matches, double weight, const RobustLoss& loss = RobustLoss())
{
    return linearizing(std::make_shared<LineTerm>(0, 1, MOVING, TARGET, matches, STEP, weight, loss));
}

TEST(Gcpw_LineTerm, it_is_zero_at_the_truth)
{
    const TermState truth = affineState();
    RecordingEquations equations(truth.lattices());
    EXPECT_NEAR(accumulateLines(matchesOf(truth, 20, 0, 3), 2)(truth, equations), 0, 1e-15);
    EXPECT_FALSE(equations.rows.empty());
    EXPECT_LT(equations.gradient().norm(), 1e-6);
}

TEST(Gcpw_LineTerm, samples_lie_every_few_pixels_from_end_to_end)
{
    const TermState state = affineState();
    LineMatch match;
    match.a = {Point2d(10, 10), Point2d(10 + 23, 10)};
    match.b = {Point2d(10, 20), Point2d(40, 20)};
    RecordingEquations equations(state.lattices());
    accumulateLines({match}, 1)(state, equations);
    ASSERT_EQ(equations.rows.size(), 5u); // 23 px: four steps of at least 5 px
    match.a.end = match.a.start + Point2d(2, 0);
    RecordingEquations of_short(state.lattices());
    accumulateLines({match}, 1)(state, of_short);
    EXPECT_EQ(of_short.rows.size(), 2u) << "both ends at least";
}

TEST(Gcpw_LineTerm, its_energy_is_the_weighted_sum_of_squared_distances_to_the_target_line)
{
    const TermState state = bentState();
    LineMatch match;
    match.a = {Point2d(10, 10), Point2d(50, 40)}; // 50 px: eleven samples
    match.b = {Point2d(20, 15), Point2d(60, 52)};
    match.weight = 0.7;
    const Line line = Segment{state.meshes[1].warp(match.b.start), state.meshes[1].warp(match.b.end)}.line();
    double expected = 0;
    for (int k = 0; k <= 10; ++k)
        expected += 2 * 0.7 * std::pow(line.distance(state.meshes[0].warp(match.a.at(0.1 * k))), 2);
    RecordingEquations equations(state.lattices());
    EXPECT_NEAR(accumulateLines({match}, 2)(state, equations), expected, 1e-9 * expected);
}

TEST(Gcpw_LineTerm, energy_equals_the_sum_of_squared_rows)
{
    const TermState state = bentState();
    expectEnergyIsSumOfRows(accumulateLines(matchesOf(affineState(), 20, 5, 4), 2), state);
}

TEST(Gcpw_LineTerm, jacobian_by_the_moving_image_equals_finite_differences)
{
    const TermState state = bentState();
    const LinearizeTerm accumulate = accumulateLines(matchesOf(affineState(), 20, 5, 5), 2);
    expectExactlyQuadratic(accumulate, state, 0, MOVING_COLUMNS, 2.0, 1e-9);
    expectGradientIsSlope(accumulate, state, 0, MOVING_COLUMNS, 1e-3, 1e-7);
}

TEST(Gcpw_LineTerm, a_robust_gradient_is_the_slope_of_the_robust_energy)
{
    expectGradientIsSlope(accumulateLines(matchesOf(affineState(), 20, 5, 6), 2, RobustLoss(2)), bentState(), 0,
                          MOVING_COLUMNS, 1e-4, 1e-6);
}

TEST(Gcpw_LineTerm, jacobian_by_the_target_equals_finite_differences_while_the_segment_stays_straight)
{
    // A segment along a row of one quad of the target: its points move as its two ends do, so that the row is exact.
    const TermState state = affineState();
    LineMatch match;
    match.b = {Point2d(22, 30), Point2d(37, 30)};
    const Matx22d back = Matx22d(1.1, 0.1, -0.05, 0.95).inv();
    const auto inMoving = [&](Point2d canvas)
    {
        const Vec2d p = back * Vec2d(canvas.x - 6, canvas.y - 9);
        return Point2d(p[0], p[1]);
    };
    match.a = {inMoving(Point2d(24, 33)), inMoving(Point2d(35, 31))};
    ASSERT_EQ(TARGET.locate(match.b.start).cell, TARGET.locate(match.b.end).cell);
    const LinearizeTerm accumulate = accumulateLines({match}, 1);
    RecordingEquations equations(state.lattices());
    expectGradientIsSlope(accumulate, state, MOVING_COLUMNS, equations.meshColumns(), 1e-4, 1e-6);
}

TEST(Gcpw_LineTerm, sliding_along_the_line_changes_nothing)
{
    const TermState state = affineState();
    LineMatch match;
    match.b = {Point2d(20, 20), Point2d(70, 50)};
    match.a = {Point2d(10, 12), Point2d(50, 30)};
    const LinearizeTerm accumulate = accumulateLines({match}, 1);
    TermState slid = state;
    slid.meshes[0] = affineMesh(state.meshes[0], Matx22d::eye(), 0.2 * match.b.direction());
    RecordingEquations one(state.lattices());
    RecordingEquations other(state.lattices());
    EXPECT_GT(accumulate(state, one), 1);
    EXPECT_NEAR(accumulate(state, one), accumulate(slid, other), 1e-9);
}

TEST(Gcpw_LineTerm, moving_both_images_alike_changes_nothing)
{
    const TermState state = bentState();
    TermState shifted = state;
    for (MeshGrid& mesh : shifted.meshes)
        mesh = affineMesh(mesh, Matx22d::eye(), Point2d(13, -9));
    const LinearizeTerm accumulate = accumulateLines(matchesOf(affineState(), 20, 5, 7), 2);
    RecordingEquations one(state.lattices());
    RecordingEquations other(state.lattices());
    EXPECT_NEAR(accumulate(state, one), accumulate(shifted, other), 1e-8);
    for (const RecordingEquations::Row& row : one.rows)
        for (int axis = 0; axis < 2; ++axis)
        {
            double sum = 0;
            for (int k = axis; k < 8; k += 2)
                sum += row.row_a[k] + row.row_b[k];
            EXPECT_NEAR(sum, 0, 1e-12);
        }
}

TEST(Gcpw_LineTerm, distances_are_root_mean_squares_in_the_order_given)
{
    const TermState state = affineState();
    const std::vector<LineMatch> matches = matchesOf(state, 8, 6, 8);
    const std::vector<double> distances =
        LineTerm(0, 1, MOVING, TARGET, matches, STEP, 1).distances(state.state());
    ASSERT_EQ(distances.size(), matches.size());
    for (size_t i = 0; i < matches.size(); ++i)
    {
        // The target is parallel: every sample is equally far.
        const double expected = std::abs(matches[i].b.line().distance(state.meshes[0].warp(matches[i].a.start)));
        EXPECT_NEAR(distances[i], expected, 1e-9);
    }
}

TEST(Gcpw_LineTerm, without_matches_there_are_no_rows)
{
    const TermState state = bentState();
    RecordingEquations equations(state.lattices());
    EXPECT_EQ(accumulateLines({}, 2)(state, equations), 0);
    EXPECT_TRUE(equations.empty());
}

TEST(Gcpw_LineTerm, a_target_without_length_gives_no_rows)
{
    const TermState state = affineState();
    LineMatch match;
    match.a = {Point2d(10, 10), Point2d(40, 10)};
    match.b = {Point2d(20, 20), Point2d(20, 20)};
    RecordingEquations equations(state.lattices());
    EXPECT_EQ(accumulateLines({match}, 1)(state, equations), 0);
    EXPECT_TRUE(equations.empty());
}

TEST(Gcpw_LineTerm, a_target_whose_ends_a_mesh_brings_together_gives_no_rows)
{
    TermState state = affineState();
    for (Point2d& vertex : state.meshes[1].vertices())
        vertex = Point2d(20, 20);
    LineMatch match;
    match.a = {Point2d(10, 10), Point2d(40, 10)};
    match.b = {Point2d(20, 20), Point2d(60, 20)};
    RecordingEquations equations(state.lattices());
    EXPECT_EQ(accumulateLines({match}, 1)(state, equations), 0);
    EXPECT_TRUE(equations.empty());
    EXPECT_EQ(LineTerm(0, 1, MOVING, TARGET, {match}, STEP, 1).distances(state.state())[0],
              std::numeric_limits<double>::infinity());
}

TEST(Gcpw_LineTerm, matches_that_are_not_finite_give_no_rows)
{
    const TermState state = affineState();
    LineMatch good;
    good.a = {Point2d(10, 10), Point2d(40, 10)};
    good.b = {Point2d(20, 20), Point2d(60, 20)};
    for (const double bad : {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity(), 1e300})
    {
        std::vector<LineMatch> matches(5, good);
        matches[0].a.start.x = bad;
        matches[1].a.end.y = bad;
        matches[2].b.start.y = bad;
        matches[3].b.end.x = bad;
        matches[4].weight = bad < 1e308 ? -1 : bad;
        RecordingEquations equations(state.lattices());
        EXPECT_EQ(accumulateLines(matches, 1)(state, equations), 0) << bad;
        EXPECT_TRUE(equations.empty()) << bad;
    }
}

TEST(Gcpw_LineTerm, a_tiny_step_does_not_flood_memory)
{
    const TermState state = affineState();
    LineMatch match;
    match.a = {Point2d(10, 10), Point2d(40, 10)};
    match.b = {Point2d(20, 20), Point2d(60, 20)};
    LineTerm term(0, 1, MOVING, TARGET, {match}, 1e-300, 1);
    RecordingEquations equations(state.lattices());
    EXPECT_GT(term.linearize(state.state(), equations), 0);
    EXPECT_EQ(equations.rows.size(), 10001u);
}

TEST(Gcpw_LineTerm, samples_outside_the_moving_image_give_no_rows)
{
    const TermState state = affineState();
    LineMatch match;
    match.a = {Point2d(-20, 30), Point2d(-10, 30)};
    match.b = {Point2d(20, 20), Point2d(40, 20)};
    RecordingEquations equations(state.lattices());
    EXPECT_EQ(accumulateLines({match}, 1)(state, equations), 0);
    EXPECT_TRUE(equations.empty());
}

TEST(Gcpw_LineTerm, a_step_that_leads_nowhere_is_refused)
{
    EXPECT_THROW(LineTerm(0, 1, MOVING, TARGET, {}, 0, 1), cv::Exception);
    EXPECT_THROW(LineTerm(0, 1, MOVING, TARGET, {}, -5, 1), cv::Exception);
}

}} // namespace
