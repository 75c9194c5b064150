// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#include "test_precomp.hpp"

#include "photometric_scene.hpp"

namespace opencv_test { namespace {

using namespace cv::gcpw;

LinearizeTerm accumulatePixels(const PyramidLevel& source, const PyramidLevel& target, double contrast_floor = 0,
                    const RobustLoss& loss = RobustLoss(), int step = 3, bool target_moves = false)
{
    PhotometricTerm::Options options;
    options.weight = WEIGHT;
    options.loss = loss;
    options.target_moves = target_moves;
    return linearizing(photometricTerm(source, target, options, step, contrast_floor));
}

/// The same where the target is free to move.
LinearizeTerm accumulateBothSides(const PyramidLevel& source, const PyramidLevel& target)
{
    return accumulatePixels(source, target, 0, RobustLoss(), 3, true);
}

/// What the source must show so that a state is the truth about a target picture.
Picture seenThrough(const TermState& state, const Picture& picture)
{
    return [state, picture](Point2d reference_px, int c)
    {
        int hint = -1;
        CellPoint target;
        CV_Assert(state.meshes[1].invert(state.meshes[0].warp(reference_px), hint, target));
        const ChannelAffine& mine = state.colors[0].quad(SOURCE.locate(reference_px).cell)[c];
        const ChannelAffine& theirs = state.colors[1].quad(target.cell)[c];
        return (theirs.gain * picture(TARGET.referencePoint(target), c) + theirs.bias - mine.bias) / mine.gain;
        };
}

int sampleCount(const RecordingEquations& equations)
{
    int count = 0;
    for (const RecordingEquations::Block& item : equations.blocks)
        count += item.block.samples;
    return count;
}

TEST(Gcpw_PhotometricTerm, it_is_zero_at_the_truth_whatever_meshes_and_colors_are)
{
    for (const TermState& truth : {bentState(), movedState()})
    {
        const PyramidLevel target = levelOf(TARGET, 1, ramp);
        RecordingEquations equations(truth.lattices());
        EXPECT_NEAR(accumulatePixels(levelOf(SOURCE, 1, seenThrough(truth, ramp)), target)(truth, equations), 0, 1e-8);
        EXPECT_EQ(sampleCount(equations), 20 * 15);
        RecordingEquations wrong(truth.lattices());
        EXPECT_GT(accumulatePixels(levelOf(SOURCE, 1, waves), target)(truth, wrong), 1);
    }
}

TEST(Gcpw_PhotometricTerm, what_it_adds_is_exact_where_residuals_are_linear)
{
    // On ramps one linearisation says the energy of every mesh and of every colour, one at a time.
    for (const TermState& state : {bentState(), movedState()})
    {
        const LinearizeTerm accumulate = accumulatePixels(levelOf(SOURCE, 1, waves), levelOf(TARGET, 1, ramp));
        RecordingEquations equations(state.lattices());
        expectExactlyQuadratic(accumulate, state, 0, SOURCE_MESH, 1.0, 1e-5);
        const int first_color = equations.colorColumn({0, 0}, 0);
        const int last_color = first_color + 6 * SOURCE.cellCount();
        expectExactlyQuadratic(accumulate, state, first_color, last_color, 0.2, 1e-5);
    }
}

TEST(Gcpw_PhotometricTerm, meshes_and_colors_are_coupled_exactly)
{
    const TermState state = bentState();
    const LinearizeTerm accumulate = accumulatePixels(levelOf(SOURCE, 1, waves), levelOf(TARGET, 1, ramp));
    RecordingEquations equations(state.lattices());
    const double energy = accumulate(state, equations);
    Eigen::VectorXd d = randomMotion(equations, 0, SOURCE_MESH, 4);
    const int first_color = equations.colorColumn({0, 0}, 0);
    d += 0.2 * randomMotion(equations, first_color, first_color + 6 * SOURCE.cellCount(), 5);
    RecordingEquations ignored(state.lattices());
    const double found = accumulate(state.moved(d), ignored);
    EXPECT_NEAR(found, energy + 2 * equations.gradient().dot(d) + d.dot(equations.matrix() * d), 1e-5 * found);
}

TEST(Gcpw_PhotometricTerm, the_gradient_follows_the_energy_of_a_smooth_picture)
{
    // Over a pixel: within one, bilinear sampling is a polygon whose slope jumps about the picture's.
    for (const TermState& state : {bentState(), movedState()})
        expectGradientIsSlope(accumulatePixels(levelOf(SOURCE, 1, otherWaves), levelOf(TARGET, 1, waves)), state, 0,
                              SOURCE_MESH, 0.5, 0.03);
}

TEST(Gcpw_PhotometricTerm, on_a_coarse_level_units_stay_those_of_the_reference_image)
{
    const TermState state = bentState();
    const LinearizeTerm accumulate = accumulatePixels(levelOf(SOURCE, 2.5, waves), levelOf(TARGET, 2.5, ramp));
    expectExactlyQuadratic(accumulate, state, 0, SOURCE_MESH, 1.0, 1e-5);
    const TermState truth = bentState();
    RecordingEquations equations(truth.lattices());
    EXPECT_NEAR(accumulatePixels(levelOf(SOURCE, 2.5, seenThrough(truth, ramp)), levelOf(TARGET, 2.5, ramp))(truth, equations), 0,
                1e-8);
}

TEST(Gcpw_PhotometricTerm, a_robust_gradient_is_the_slope_of_the_robust_energy)
{
    const TermState state = bentState();
    const LinearizeTerm accumulate = accumulatePixels(levelOf(SOURCE, 1, waves), levelOf(TARGET, 1, ramp), 0, RobustLoss(0.4));
    RecordingEquations equations(state.lattices());
    expectGradientIsSlope(accumulate, state, 0, SOURCE_MESH, 0.02, 1e-3);
    const int first_color = equations.colorColumn({0, 0}, 0);
    expectGradientIsSlope(accumulate, state, first_color, first_color + 6 * SOURCE.cellCount(), 1e-3, 1e-3);
}

TEST(Gcpw_PhotometricTerm, energy_equals_the_sum_of_the_accumulated_blocks)
{
    for (const RobustLoss& loss : {RobustLoss(), RobustLoss(0.1)})
        expectEnergyIsSumOfRows(accumulatePixels(levelOf(SOURCE, 1, waves), levelOf(TARGET, 1, otherWaves), 0, loss),
                                movedState());
}

TEST(Gcpw_PhotometricTerm, a_change_of_color_that_the_model_undoes_is_not_felt)
{
    const PyramidLevel target = levelOf(TARGET, 1, waves);
    const auto recolored = [](Point2d p, int c) { return (otherWaves(p, c) - 0.07 * c) / (0.7 + 0.3 * c); };
    TermState state = bentState();
    RecordingEquations plain(state.lattices());
    const double energy = accumulatePixels(levelOf(SOURCE, 1, otherWaves), target)(state, plain);
    for (int cell = 0; cell < SOURCE.cellCount(); ++cell)
        for (int c = 0; c < CHANNELS; ++c)
            state.colors[0].quad(cell)[c] = {0.7 + 0.3 * c, 0.07 * c};
    RecordingEquations compensated(state.lattices());
    EXPECT_NEAR(accumulatePixels(levelOf(SOURCE, 1, recolored), target)(state, compensated), energy, 1e-4 * energy);
    EXPECT_LT((plain.gradient().head(SOURCE_MESH) - compensated.gradient().head(SOURCE_MESH)).norm(),
              1e-4 * plain.gradient().head(SOURCE_MESH).norm());
}

TEST(Gcpw_PhotometricTerm, moving_both_images_alike_changes_nothing)
{
    const LinearizeTerm accumulate = accumulatePixels(levelOf(SOURCE, 1, otherWaves), levelOf(TARGET, 1, waves));
    const TermState state = bentState();
    TermState shifted = state;
    for (MeshGrid& mesh : shifted.meshes)
        mesh = affineMesh(mesh, Matx22d::eye(), Point2d(64, -32));
    RecordingEquations one(state.lattices());
    RecordingEquations other(state.lattices());
    const double energy = accumulate(state, one);
    EXPECT_NEAR(accumulate(shifted, other), energy, 1e-6 * energy);
    EXPECT_LT((one.gradient() - other.gradient()).norm(), 1e-6 * one.gradient().norm());
}

TEST(Gcpw_PhotometricTerm, samples_lie_every_few_pixels_of_the_level)
{
    const TermState state = bentState();
    const PyramidLevel target = levelOf(TARGET, 1, waves);
    for (const int step : {1, 2, 7})
    {
        RecordingEquations equations(state.lattices());
        accumulatePixels(levelOf(SOURCE, 1, waves), target, 0, RobustLoss(), step)(state, equations);
        const int cols = (60 - step / 2 + step - 1) / step;
        const int rows = (45 - step / 2 + step - 1) / step;
        EXPECT_EQ(sampleCount(equations), cols * rows) << step;
    }
}

TEST(Gcpw_PhotometricTerm, outside_the_target_there_are_no_samples)
{
    const LinearizeTerm accumulate = accumulatePixels(levelOf(SOURCE, 1, waves), levelOf(TARGET, 1, otherWaves));
    for (const Point2d& origin : {Point2d(-70, 10), Point2d(130, 10), Point2d(20, -60), Point2d(20, 100)})
    {
        const TermState state({MeshGrid(SOURCE, origin), MeshGrid(TARGET)});
        RecordingEquations equations(state.lattices());
        EXPECT_EQ(accumulate(state, equations), 0);
        EXPECT_TRUE(equations.empty());
    }
    const TermState half({MeshGrid(SOURCE, Point2d(89.5, 20)), MeshGrid(TARGET)});
    RecordingEquations equations(half.lattices());
    EXPECT_GT(accumulate(half, equations), 0);
    EXPECT_EQ(sampleCount(equations), 10 * 15) << "columns 1, 4 .. 28 of the source are inside";
}

TEST(Gcpw_PhotometricTerm, outside_either_mask_there_are_no_samples)
{
    const TermState state({MeshGrid(SOURCE, Point2d(30, 20)), MeshGrid(TARGET)});
    PyramidLevel source = levelOf(SOURCE, 1, waves);
    PyramidLevel target = levelOf(TARGET, 1, otherWaves);
    for (int y = 0; y < 45; ++y)
        for (int x = 0; x < 30; ++x)
            source.pixels.at<Vec4f>(y, x)[3] = 0;
    RecordingEquations masked_source(state.lattices());
    accumulatePixels(source, target)(state, masked_source);
    EXPECT_EQ(sampleCount(masked_source), 10 * 15);
    for (int y = 0; y < 90; ++y)
        for (int x = 75; x < 120; ++x)
            target.pixels.at<Vec4f>(y, x)[3] = 0;
    RecordingEquations masked_both(state.lattices());
    accumulatePixels(source, target)(state, masked_both);
    EXPECT_EQ(sampleCount(masked_both), 5 * 15);
}

TEST(Gcpw_PhotometricTerm, a_mesh_that_is_not_a_number_has_no_samples)
{
    TermState state = bentState();
    for (Point2d& vertex : state.meshes[0].vertices())
        vertex.x = std::numeric_limits<double>::quiet_NaN();
    RecordingEquations equations(state.lattices());
    EXPECT_EQ(accumulatePixels(levelOf(SOURCE, 1, waves), levelOf(TARGET, 1, waves))(state, equations), 0);
    EXPECT_TRUE(equations.empty());
}

TEST(Gcpw_PhotometricTerm, the_gradient_by_a_moving_target_is_the_slope)
{
    for (const TermState& state : {bentState(), movedState()})
    {
        const LinearizeTerm accumulate = accumulateBothSides(levelOf(SOURCE, 1, waves), levelOf(TARGET, 1, ramp));
        RecordingEquations equations(state.lattices());
        // Samples that cross the quads' borders see another slope: small steps.
        expectGradientIsSlope(accumulate, state, 0, equations.meshColumns(), 1e-3, 2e-3);
        expectGradientIsSlope(accumulate, state, SOURCE_MESH, equations.meshColumns(), 1e-3, 2e-3);
    }
}

TEST(Gcpw_PhotometricTerm, the_colors_of_both_images_are_coupled_exactly)
{
    const TermState state = movedState();
    const LinearizeTerm accumulate = accumulateBothSides(levelOf(SOURCE, 1, waves), levelOf(TARGET, 1, otherWaves));
    RecordingEquations equations(state.lattices());
    expectExactlyQuadratic(accumulate, state, equations.meshColumns(), equations.columns(), 0.2, 1e-5);
}

TEST(Gcpw_PhotometricTerm, near_the_truth_the_accumulated_matrix_is_the_energy_of_both_meshes)
{
    const TermState truth = movedState();
    const LinearizeTerm accumulate = accumulateBothSides(levelOf(SOURCE, 1, seenThrough(truth, ramp)), levelOf(TARGET, 1, ramp));
    RecordingEquations equations(truth.lattices());
    accumulate(truth, equations);
    const Eigen::MatrixXd matrix = equations.matrix();
    for (int trial = 0; trial < 10; ++trial)
    {
        const Eigen::VectorXd d = 0.02 * randomMotion(equations, 0, equations.meshColumns(), trial);
        RecordingEquations ignored(truth.lattices());
        const double found = accumulate(truth.moved(d), ignored);
        EXPECT_GT(found, 1e-4);
        EXPECT_NEAR(d.dot(matrix * d), found, 0.02 * found);
    }
}

TEST(Gcpw_PhotometricTerm, what_is_accumulated_does_not_feel_a_motion_of_both_meshes)
{
    const TermState state = movedState();
    RecordingEquations equations(state.lattices());
    accumulateBothSides(levelOf(SOURCE, 1, waves), levelOf(TARGET, 1, otherWaves))(state, equations);
    Eigen::VectorXd right = Eigen::VectorXd::Zero(equations.columns());
    for (int k = 0; k < equations.meshColumns(); k += 2)
        right[k] = 1;
    EXPECT_LT(std::abs(equations.gradient().dot(right)), 1e-5 * equations.gradient().norm());
    EXPECT_LT((equations.matrix() * right).head(equations.meshColumns()).norm(), 1e-5 * equations.matrix().norm());
}

TEST(Gcpw_PhotometricTerm, a_target_that_is_fixed_gets_nothing)
{
    const TermState state = movedState();
    RecordingEquations fixed(state.lattices());
    RecordingEquations moving(state.lattices());
    accumulatePixels(levelOf(SOURCE, 1, waves), levelOf(TARGET, 1, otherWaves))(state, fixed);
    accumulateBothSides(levelOf(SOURCE, 1, waves), levelOf(TARGET, 1, otherWaves))(state, moving);
    EXPECT_TRUE(fixed.targets.empty());
    EXPECT_FALSE(moving.targets.empty());
    EXPECT_EQ(fixed.energy(), moving.energy());
    EXPECT_EQ(fixed.gradient().head(SOURCE_MESH), moving.gradient().head(SOURCE_MESH));
}

TEST(Gcpw_PhotometricTerm, a_contrast_floor_weighs_samples_by_their_local_variance)
{
    const TermState state = bentState();
    const auto flat = [](Point2d, int) { return 0.3; };
    const auto brighter = [](Point2d, int) { return 0.5; };
    RecordingEquations equations(state.lattices());
    // No variance: every sample counts 0.01 / floor^2.
    const double floor = 0.05;
    const double expected = WEIGHT * 300 * 3 * 0.2 * 0.2 * 0.01 / (floor * floor);
    EXPECT_NEAR(accumulatePixels(levelOf(SOURCE, 1, flat), levelOf(TARGET, 1, brighter), floor)(state, equations), expected,
                1e-4 * expected);
    expectEnergyIsSumOfRows(accumulatePixels(levelOf(SOURCE, 1, waves), levelOf(TARGET, 1, otherWaves), floor), state);
    expectExactlyQuadratic(accumulatePixels(levelOf(SOURCE, 1, waves), levelOf(TARGET, 1, ramp), floor), state, 0,
                           SOURCE_MESH, 1.0, 1e-5);
}

TEST(Gcpw_PhotometricTerm, its_parts_are_the_whole)
{
    const TermState state = movedState();
    PhotometricTerm::Options options;
    options.weight = WEIGHT;
    options.gain_support = 3;
    options.target_moves = true;
    const auto term = photometricTerm(levelOf(SOURCE, 1, waves), levelOf(TARGET, 1, otherWaves), options);
    RecordingEquations whole(state.lattices());
    RecordingEquations parts(state.lattices());
    const double energy = linearizing(term)(state, whole);
    EXPECT_NEAR(linearizingParts(term)(state, parts), energy, 1e-9 * std::abs(energy));
    EXPECT_EQ(whole.gradient(), parts.gradient());
    EXPECT_EQ(whole.matrix(), parts.matrix());
    const State moved = bentState().state();
    double sum = 0;
    for (int part = 0; part < term->parts(); ++part)
        sum += term->evaluatePart(moved, part);
    EXPECT_NEAR(sum, term->evaluate(moved), 1e-9 * std::abs(sum));
}

TEST(Gcpw_OverlapSamples, no_step_and_levels_of_unequal_scale_are_refused)
{
    const PyramidLevel level = levelOf(SOURCE, 1, waves);
    EXPECT_THROW(OverlapSamples(0, 1, level, level, SOURCE, 0), cv::Exception);
    EXPECT_THROW(OverlapSamples(0, 1, level, levelOf(TARGET, 2, waves), SOURCE, 3), cv::Exception);
}

}} // namespace
