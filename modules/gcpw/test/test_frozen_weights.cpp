// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#include "test_precomp.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include "photometric_scene.hpp"

namespace opencv_test { namespace {

using namespace cv::gcpw;

TEST(Gcpw_FrozenWeights, colors_of_images_that_do_not_match_are_still_a_sum_of_squares)
{
    // Such a quad counts less for both images or for none, or else the colours have no minimum.
    const TermState state = movedState();
    PhotometricTerm::Options options;
    options.gain_support = 3;
    options.target_moves = true;
    const auto term = photometricTerm(levelOf(SOURCE, 1, waves), levelOf(TARGET, 1, otherWaves), options, 1);
    RecordingEquations equations(state.lattices());
    term->linearize(state.state(), equations);
    ASSERT_FALSE(equations.targets.empty());
    const Eigen::Index colors = equations.columns() - equations.meshColumns();
    const Eigen::VectorXd values =
        Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(equations.matrix().bottomRightCorner(colors, colors)).eigenvalues();
    EXPECT_GE(values.minCoeff(), -1e-9 * values.maxCoeff());
}

TEST(Gcpw_FrozenWeights, what_a_quads_colors_count_for_is_one_function_until_the_next_linearisation)
{
    for (const bool target_moves : {false, true})
    {
        const TermState base = movedState();
        PhotometricTerm::Options options;
        options.weight = WEIGHT;
        options.gain_support = 3;
        options.target_moves = target_moves;
        options.loss = RobustLoss(0.4);
        const auto term = photometricTerm(levelOf(SOURCE, 1, waves), levelOf(TARGET, 1, ramp), options);
        RecordingEquations equations(base.lattices());
        const double energy = term->linearize(base.state(), equations);
        EXPECT_NEAR(term->evaluate(base.state()), energy, 1e-9 * std::abs(energy)) << "value";
        // Recorded once, at the base; elsewhere the frozen function is evaluated.
        bool first = true;
        const LinearizeTerm frozen = [&](const TermState& at, NormalEquations& to) -> double
        {
            if (first)
                for (const RecordingEquations::Block& item : equations.blocks)
                    to.addPhotometric(item.quad, item.block);
            for (size_t k = 0; first && k < equations.targets.size(); ++k)
                to.addCross(equations.targets[k].a, equations.targets[k].b, equations.targets[k].block);
            first = false;
            return term->evaluate(at.state());
        };
        expectGradientIsSlope(frozen, base, 0, target_moves ? equations.meshColumns() : SOURCE_MESH, 0.02, 2e-3);
        first = true;
        const int first_color = equations.colorColumn({0, 0}, 0);
        const int last_color = target_moves ? equations.columns() : first_color + 6 * SOURCE.cellCount();
        expectGradientIsSlope(frozen, base, first_color, last_color, 1e-3, 1e-3);
    }
}

}} // namespace
