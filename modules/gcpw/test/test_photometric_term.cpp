// Part of the GCPW module for OpenCV. Licence: Apache-2.0 (see LICENSE).
#include "test_precomp.hpp"

#include "photometric_scene.hpp"

namespace opencv_test { namespace {

using namespace cv::gcpw;

PourTerm pourPixels(const PyramidLevel& source, const PyramidLevel& target, double contrast_floor = 0,
                    const RobustLoss& loss = RobustLoss(), int step = 3, bool target_moves = false)
{
    PhotometricTerm::Options options;
    options.step = step;
    options.weight = WEIGHT;
    options.contrast_floor = contrast_floor;
    const PhotometricTerm term(0, 1, source, target, SOURCE, options);
    return [term, loss, target_moves](const TermState& state, ResidualSink& sink)
    {
        const std::vector<ImageState> images = {{state.meshes[0], state.colors[0]}, {state.meshes[1], state.colors[1]}};
        return term.linearize(images, target_moves, loss, sink);
        };
}

/// The same where the target is free to move.
PourTerm pourBothSides(const PyramidLevel& source, const PyramidLevel& target)
{
    return pourPixels(source, target, 0, RobustLoss(), 3, true);
}

/// What the source must show so that a state is the truth about a target picture.
Picture seenThrough(const TermState& state, const Picture& picture)
{
    return [state, picture](Point2d rest_px, int c)
    {
        int hint = -1;
        CellPoint partner;
        CV_Assert(state.meshes[1].invert(state.meshes[0].warp(rest_px), hint, partner));
        const ChannelAffine& mine = state.colors[0].quad(SOURCE.locate(rest_px).cell)[c];
        const ChannelAffine& theirs = state.colors[1].quad(partner.cell)[c];
        return (theirs.gain * picture(TARGET.restPoint(partner), c) + theirs.bias - mine.bias) / mine.gain;
        };
}

int sampleCount(const RecordingSink& sink)
{
    int count = 0;
    for (const RecordingSink::Block& item : sink.blocks)
        count += item.block.samples;
    return count;
}

TEST(Gcpw_PhotometricTerm, it_is_zero_at_the_truth_whatever_meshes_and_colors_are)
{
    for (const TermState& truth : {bentState(), movedState()})
    {
        const PyramidLevel target = levelOf(TARGET, 1, ramp);
        RecordingSink sink(truth.lattices());
        EXPECT_NEAR(pourPixels(levelOf(SOURCE, 1, seenThrough(truth, ramp)), target)(truth, sink), 0, 1e-8);
        EXPECT_EQ(sampleCount(sink), 20 * 15);
        RecordingSink wrong(truth.lattices());
        EXPECT_GT(pourPixels(levelOf(SOURCE, 1, waves), target)(truth, wrong), 1);
    }
}

TEST(Gcpw_PhotometricTerm, what_it_pours_is_exact_where_residuals_are_linear)
{
    // On ramps one linearisation says the energy of every mesh and of every colour, one at a time.
    for (const TermState& state : {bentState(), movedState()})
    {
        const PourTerm pour = pourPixels(levelOf(SOURCE, 1, waves), levelOf(TARGET, 1, ramp));
        RecordingSink sink(state.lattices());
        expectExactlyQuadratic(pour, state, 0, SOURCE_MESH, 1.0, 1e-5);
        const int first_color = sink.colorColumn({0, 0}, 0);
        const int last_color = first_color + 6 * SOURCE.cellCount();
        expectExactlyQuadratic(pour, state, first_color, last_color, 0.2, 1e-5);
    }
}

TEST(Gcpw_PhotometricTerm, meshes_and_colors_are_coupled_exactly)
{
    const TermState state = bentState();
    const PourTerm pour = pourPixels(levelOf(SOURCE, 1, waves), levelOf(TARGET, 1, ramp));
    RecordingSink sink(state.lattices());
    const double energy = pour(state, sink);
    Eigen::VectorXd d = randomMotion(sink, 0, SOURCE_MESH, 4);
    const int first_color = sink.colorColumn({0, 0}, 0);
    d += 0.2 * randomMotion(sink, first_color, first_color + 6 * SOURCE.cellCount(), 5);
    RecordingSink ignored(state.lattices());
    const double found = pour(state.moved(d), ignored);
    EXPECT_NEAR(found, energy + 2 * sink.gradient().dot(d) + d.dot(sink.matrix() * d), 1e-5 * found);
}

TEST(Gcpw_PhotometricTerm, the_gradient_follows_the_energy_of_a_smooth_picture)
{
    // Over a pixel: within one, bilinear sampling is a polygon whose slope jumps about the picture's.
    for (const TermState& state : {bentState(), movedState()})
        expectGradientIsSlope(pourPixels(levelOf(SOURCE, 1, otherWaves), levelOf(TARGET, 1, waves)), state, 0,
                              SOURCE_MESH, 0.5, 0.03);
}

TEST(Gcpw_PhotometricTerm, on_a_coarse_level_units_stay_those_of_the_rest_image)
{
    const TermState state = bentState();
    const PourTerm pour = pourPixels(levelOf(SOURCE, 2.5, waves), levelOf(TARGET, 2.5, ramp));
    expectExactlyQuadratic(pour, state, 0, SOURCE_MESH, 1.0, 1e-5);
    const TermState truth = bentState();
    RecordingSink sink(truth.lattices());
    EXPECT_NEAR(pourPixels(levelOf(SOURCE, 2.5, seenThrough(truth, ramp)), levelOf(TARGET, 2.5, ramp))(truth, sink), 0,
                1e-8);
}

TEST(Gcpw_PhotometricTerm, a_robust_gradient_is_the_slope_of_the_robust_energy)
{
    const TermState state = bentState();
    const PourTerm pour = pourPixels(levelOf(SOURCE, 1, waves), levelOf(TARGET, 1, ramp), 0, RobustLoss(0.4));
    RecordingSink sink(state.lattices());
    expectGradientIsSlope(pour, state, 0, SOURCE_MESH, 0.02, 1e-3);
    const int first_color = sink.colorColumn({0, 0}, 0);
    expectGradientIsSlope(pour, state, first_color, first_color + 6 * SOURCE.cellCount(), 1e-3, 1e-3);
}

TEST(Gcpw_PhotometricTerm, energy_equals_the_sum_of_the_poured_blocks)
{
    for (const RobustLoss& loss : {RobustLoss(), RobustLoss(0.1)})
        expectEnergyIsSumOfRows(pourPixels(levelOf(SOURCE, 1, waves), levelOf(TARGET, 1, otherWaves), 0, loss),
                                movedState());
}

TEST(Gcpw_PhotometricTerm, a_change_of_color_that_the_model_undoes_is_not_felt)
{
    const PyramidLevel target = levelOf(TARGET, 1, waves);
    const auto recolored = [](Point2d p, int c) { return (otherWaves(p, c) - 0.07 * c) / (0.7 + 0.3 * c); };
    TermState state = bentState();
    RecordingSink plain(state.lattices());
    const double energy = pourPixels(levelOf(SOURCE, 1, otherWaves), target)(state, plain);
    for (int cell = 0; cell < SOURCE.cellCount(); ++cell)
        for (int c = 0; c < CHANNELS; ++c)
            state.colors[0].quad(cell)[c] = {0.7 + 0.3 * c, 0.07 * c};
    RecordingSink compensated(state.lattices());
    EXPECT_NEAR(pourPixels(levelOf(SOURCE, 1, recolored), target)(state, compensated), energy, 1e-4 * energy);
    EXPECT_LT((plain.gradient().head(SOURCE_MESH) - compensated.gradient().head(SOURCE_MESH)).norm(),
              1e-4 * plain.gradient().head(SOURCE_MESH).norm());
}

TEST(Gcpw_PhotometricTerm, moving_both_images_alike_changes_nothing)
{
    const PourTerm pour = pourPixels(levelOf(SOURCE, 1, otherWaves), levelOf(TARGET, 1, waves));
    const TermState state = bentState();
    TermState shifted = state;
    for (MeshGrid& mesh : shifted.meshes)
        mesh = affineMesh(mesh, Matx22d::eye(), Point2d(64, -32));
    RecordingSink one(state.lattices());
    RecordingSink other(state.lattices());
    const double energy = pour(state, one);
    EXPECT_NEAR(pour(shifted, other), energy, 1e-6 * energy);
    EXPECT_LT((one.gradient() - other.gradient()).norm(), 1e-6 * one.gradient().norm());
}

TEST(Gcpw_PhotometricTerm, samples_lie_every_few_pixels_of_the_level)
{
    const TermState state = bentState();
    const PyramidLevel target = levelOf(TARGET, 1, waves);
    for (const int step : {1, 2, 7})
    {
        RecordingSink sink(state.lattices());
        pourPixels(levelOf(SOURCE, 1, waves), target, 0, RobustLoss(), step)(state, sink);
        const int cols = (60 - step / 2 + step - 1) / step;
        const int rows = (45 - step / 2 + step - 1) / step;
        EXPECT_EQ(sampleCount(sink), cols * rows) << step;
    }
}

TEST(Gcpw_PhotometricTerm, outside_the_target_there_are_no_samples)
{
    const PourTerm pour = pourPixels(levelOf(SOURCE, 1, waves), levelOf(TARGET, 1, otherWaves));
    for (const Point2d& origin : {Point2d(-70, 10), Point2d(130, 10), Point2d(20, -60), Point2d(20, 100)})
    {
        const TermState state({MeshGrid(SOURCE, origin), MeshGrid(TARGET)});
        RecordingSink sink(state.lattices());
        EXPECT_EQ(pour(state, sink), 0);
        EXPECT_TRUE(sink.empty());
    }
    const TermState half({MeshGrid(SOURCE, Point2d(89.5, 20)), MeshGrid(TARGET)});
    RecordingSink sink(half.lattices());
    EXPECT_GT(pour(half, sink), 0);
    EXPECT_EQ(sampleCount(sink), 10 * 15) << "columns 1, 4 .. 28 of the source are inside";
}

TEST(Gcpw_PhotometricTerm, outside_either_mask_there_are_no_samples)
{
    const TermState state({MeshGrid(SOURCE, Point2d(30, 20)), MeshGrid(TARGET)});
    PyramidLevel source = levelOf(SOURCE, 1, waves);
    PyramidLevel target = levelOf(TARGET, 1, otherWaves);
    for (int y = 0; y < 45; ++y)
        for (int x = 0; x < 30; ++x)
            source.pixels.at<Vec4f>(y, x)[3] = 0;
    RecordingSink masked_source(state.lattices());
    pourPixels(source, target)(state, masked_source);
    EXPECT_EQ(sampleCount(masked_source), 10 * 15);
    for (int y = 0; y < 90; ++y)
        for (int x = 75; x < 120; ++x)
            target.pixels.at<Vec4f>(y, x)[3] = 0;
    RecordingSink masked_both(state.lattices());
    pourPixels(source, target)(state, masked_both);
    EXPECT_EQ(sampleCount(masked_both), 5 * 15);
}

TEST(Gcpw_PhotometricTerm, a_mesh_that_is_not_a_number_has_no_samples)
{
    TermState state = bentState();
    for (Point2d& vertex : state.meshes[0].vertices())
        vertex.x = std::numeric_limits<double>::quiet_NaN();
    RecordingSink sink(state.lattices());
    EXPECT_EQ(pourPixels(levelOf(SOURCE, 1, waves), levelOf(TARGET, 1, waves))(state, sink), 0);
    EXPECT_TRUE(sink.empty());
}

TEST(Gcpw_PhotometricTerm, the_gradient_by_a_moving_target_is_the_slope)
{
    for (const TermState& state : {bentState(), movedState()})
    {
        const PourTerm pour = pourBothSides(levelOf(SOURCE, 1, waves), levelOf(TARGET, 1, ramp));
        RecordingSink sink(state.lattices());
        // Samples that cross the quads' borders see another slope: small steps.
        expectGradientIsSlope(pour, state, 0, sink.meshColumns(), 1e-3, 2e-3);
        expectGradientIsSlope(pour, state, SOURCE_MESH, sink.meshColumns(), 1e-3, 2e-3);
    }
}

TEST(Gcpw_PhotometricTerm, the_colors_of_both_images_are_coupled_exactly)
{
    const TermState state = movedState();
    const PourTerm pour = pourBothSides(levelOf(SOURCE, 1, waves), levelOf(TARGET, 1, otherWaves));
    RecordingSink sink(state.lattices());
    expectExactlyQuadratic(pour, state, sink.meshColumns(), sink.columns(), 0.2, 1e-5);
}

TEST(Gcpw_PhotometricTerm, near_the_truth_the_poured_matrix_is_the_energy_of_both_meshes)
{
    const TermState truth = movedState();
    const PourTerm pour = pourBothSides(levelOf(SOURCE, 1, seenThrough(truth, ramp)), levelOf(TARGET, 1, ramp));
    RecordingSink sink(truth.lattices());
    pour(truth, sink);
    const Eigen::MatrixXd matrix = sink.matrix();
    for (int trial = 0; trial < 10; ++trial)
    {
        const Eigen::VectorXd d = 0.02 * randomMotion(sink, 0, sink.meshColumns(), trial);
        RecordingSink ignored(truth.lattices());
        const double found = pour(truth.moved(d), ignored);
        EXPECT_GT(found, 1e-4);
        EXPECT_NEAR(d.dot(matrix * d), found, 0.02 * found);
    }
}

TEST(Gcpw_PhotometricTerm, what_is_poured_does_not_feel_a_motion_of_both_meshes)
{
    const TermState state = movedState();
    RecordingSink sink(state.lattices());
    pourBothSides(levelOf(SOURCE, 1, waves), levelOf(TARGET, 1, otherWaves))(state, sink);
    Eigen::VectorXd right = Eigen::VectorXd::Zero(sink.columns());
    for (int k = 0; k < sink.meshColumns(); k += 2)
        right[k] = 1;
    EXPECT_LT(std::abs(sink.gradient().dot(right)), 1e-5 * sink.gradient().norm());
    EXPECT_LT((sink.matrix() * right).head(sink.meshColumns()).norm(), 1e-5 * sink.matrix().norm());
}

TEST(Gcpw_PhotometricTerm, a_target_that_is_held_gets_nothing)
{
    const TermState state = movedState();
    RecordingSink held(state.lattices());
    RecordingSink moving(state.lattices());
    pourPixels(levelOf(SOURCE, 1, waves), levelOf(TARGET, 1, otherWaves))(state, held);
    pourBothSides(levelOf(SOURCE, 1, waves), levelOf(TARGET, 1, otherWaves))(state, moving);
    EXPECT_TRUE(held.partners.empty());
    EXPECT_FALSE(moving.partners.empty());
    EXPECT_EQ(held.energy(), moving.energy());
    EXPECT_EQ(held.gradient().head(SOURCE_MESH), moving.gradient().head(SOURCE_MESH));
}

TEST(Gcpw_PhotometricTerm, a_contrast_floor_weighs_samples_by_their_local_variance)
{
    const TermState state = bentState();
    const auto flat = [](Point2d, int) { return 0.3; };
    const auto brighter = [](Point2d, int) { return 0.5; };
    RecordingSink sink(state.lattices());
    // No variance: every sample counts 0.01 / floor^2.
    const double floor = 0.05;
    const double expected = WEIGHT * 300 * 3 * 0.2 * 0.2 * 0.01 / (floor * floor);
    EXPECT_NEAR(pourPixels(levelOf(SOURCE, 1, flat), levelOf(TARGET, 1, brighter), floor)(state, sink), expected,
                1e-4 * expected);
    expectEnergyIsSumOfRows(pourPixels(levelOf(SOURCE, 1, waves), levelOf(TARGET, 1, otherWaves), floor), state);
    expectExactlyQuadratic(pourPixels(levelOf(SOURCE, 1, waves), levelOf(TARGET, 1, ramp), floor), state, 0,
                           SOURCE_MESH, 1.0, 1e-5);
}

TEST(Gcpw_PhotometricTerm, no_step_and_levels_of_unequal_scale_are_refused)
{
    const PyramidLevel level = levelOf(SOURCE, 1, waves);
    PhotometricTerm::Options options;
    options.step = 0;
    EXPECT_THROW(PhotometricTerm(0, 1, level, level, SOURCE, options), cv::Exception);
    EXPECT_THROW(PhotometricTerm(0, 1, level, levelOf(TARGET, 2, waves), SOURCE, PhotometricTerm::Options()),
                 cv::Exception);
}

}} // namespace
