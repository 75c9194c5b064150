// Part of the GCPW module for OpenCV. Licence: Apache-2.0 (see LICENSE).
#include "test_precomp.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include "photometric_scene.hpp"

namespace opencv_test { namespace {

using namespace cv::gcpw;

TEST(Gcpw_ColorTrust, colors_of_images_that_do_not_match_are_still_a_sum_of_squares)
{
    // Trust is taken from such a quad: of both images or of none, or else the colours have no minimum.
    const TermState state = movedState();
    PhotometricTerm::Options options;
    options.step = 1;
    options.gain_support = 3;
    const PyramidLevel target = levelOf(TARGET, 1, otherWaves);
    const PhotometricTerm term(0, 1, levelOf(SOURCE, 1, waves), target, SOURCE, options);
    RecordingSink sink(state.lattices());
    term.linearize({{state.meshes[0], state.colors[0]}, {state.meshes[1], state.colors[1]}}, true, RobustLoss(), sink);
    ASSERT_FALSE(sink.partners.empty());
    const Eigen::Index colors = sink.columns() - sink.meshColumns();
    const Eigen::VectorXd values =
        Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(sink.matrix().bottomRightCorner(colors, colors)).eigenvalues();
    EXPECT_GE(values.minCoeff(), -1e-9 * values.maxCoeff());
}

/// The energy of the function that a linearisation at `base` fixed, as a function of the state.
PourTerm pourFixed(const TermState& base, bool target_moves)
{
    const auto imagesOf = [](const TermState& state)
    { return std::vector<ImageState>{{state.meshes[0], state.colors[0]}, {state.meshes[1], state.colors[1]}}; };
    PhotometricTerm::Options options;
    options.weight = WEIGHT;
    options.gain_support = 3;
    const PhotometricTerm term(0, 1, levelOf(SOURCE, 1, waves), levelOf(TARGET, 1, ramp), SOURCE, options);
    const RobustLoss loss(0.4);
    std::vector<ColorTrust> weights(SOURCE.cellCount());
    RecordingSink ignored(base.lattices());
    term.linearize(imagesOf(base), target_moves, loss, Range(0, SOURCE.cellCount()), ignored, nullptr, weights);
    const bool doubts = std::any_of(weights.begin(), weights.end(), [](const ColorTrust& w) { return w.trust < 0.9; });
    EXPECT_TRUE(doubts) << "every quad is believed";
    return [=](const TermState& state, ResidualSink& sink)
    {
        const std::vector<ImageState> fixed_at = imagesOf(base);
        const PhotometricTerm::Fixed before{fixed_at, weights};
        std::vector<ColorTrust> next(SOURCE.cellCount());
        return term.linearize(imagesOf(state), target_moves, loss, Range(0, SOURCE.cellCount()), sink, &before, next).fixed;
    };
}

TEST(Gcpw_ColorTrust, what_a_quads_colors_are_trusted_for_is_one_function_until_the_next_linearisation)
{
    for (const bool target_moves : {false, true})
    {
        const TermState state = movedState();
        const PourTerm fixed = pourFixed(state, target_moves);
        RecordingSink sink(state.lattices());
        const double energy = fixed(state, sink);
        EXPECT_NEAR(sink.energy(), energy, 1e-9 * std::abs(energy)) << "value";
        expectGradientIsSlope(fixed, state, 0, target_moves ? sink.meshColumns() : SOURCE_MESH, 0.02, 2e-3);
        const int first_color = sink.colorColumn({0, 0}, 0);
        const int last_color = target_moves ? sink.columns() : first_color + 6 * SOURCE.cellCount();
        expectGradientIsSlope(fixed, state, first_color, last_color, 1e-3, 1e-3);
    }
}

}} // namespace
