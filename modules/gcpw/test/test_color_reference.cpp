// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#include "test_precomp.hpp"

#include <opencv2/imgproc.hpp>
#include "imaging/pyramid.hpp"
#include "color/exposures.hpp"
#include "color/color_priors.hpp"
#include "solver/color_system.hpp"
#include "api/result.hpp"
#include "scene.hpp"

namespace opencv_test { namespace {

using namespace cv::gcpw;

const Size SIZE(160, 120);
const Lattice LATTICE(SIZE, 8, 6);
const double GAINS[3] = {1, 0.7, 1.3}; ///< of the photographs' luma
const double BIASES[3] = {0, 20, -15}; ///< gray levels

/// Three photographs in a row, each overlapping the next by half; the second and third with exposures of their own.
Problem chain(bool first_held)
{
    Problem problem;
    problem.images.resize(3);
    const Texture texture(8);
    for (int i = 0; i < 3; ++i)
    {
        Mat image(SIZE, CV_8UC3);
        const Point2d origin(80 * i, 0);
        for (int y = 0; y < SIZE.height; ++y)
            for (int x = 0; x < SIZE.width; ++x)
                image.at<Vec3b>(y, x) = Vec3b(GAINS[i] * 255.0 * texture.at(origin + Point2d(x, y)) + Vec3d::all(BIASES[i]));
        problem.images[i].rough = MeshGrid(LATTICE, origin);
        problem.images[i].pyramid = buildPyramid(image, Mat(), 1);
        problem.images[i].fixed = first_held && i == 0;
    }
    return problem;
}

std::vector<OverlapSamples> overlapsOf(const Problem& problem)
{
    std::vector<OverlapSamples> overlaps;
    for (int i = 1; i < 3; ++i)
        overlaps.emplace_back(i, i - 1, problem.images[i].pyramid[0], problem.images[i - 1].pyramid[0], LATTICE, 3);
    return overlaps;
}

TEST(Gcpw_Exposures, exposures_along_a_chain_are_found)
{
    const Problem problem = chain(true);
    const std::vector<ColorGrid::Quad> found = estimateExposures(compareColors(overlapsOf(problem), roughStates(problem)), {true, false, false});
    EXPECT_NEAR(found[0][0].gain, 1, 1e-3);
    EXPECT_NEAR(found[0][0].bias, 0, 1e-3);
    for (int i = 1; i < 3; ++i)
    {
        // The map that undoes gain and bias of the photograph.
        EXPECT_NEAR(found[i][0].gain, 1 / GAINS[i], 0.03 / GAINS[i]);
        EXPECT_NEAR(found[i][0].bias, -BIASES[i] / 255 / GAINS[i], 0.02);
    }
}

TEST(Gcpw_Exposures, an_image_that_is_fixed_keeps_its_own_colors_to_the_last_bit)
{
    const Problem problem = chain(true);
    const std::vector<ColorComparison> comparisons = compareColors(overlapsOf(problem), roughStates(problem));
    const ColorGrid::Quad first = estimateExposures(comparisons, {true, false, false})[0];
    for (const ChannelAffine& map : first)
    {
        EXPECT_EQ(map.gain, 1);
        EXPECT_EQ(map.bias, 0);
    }
    for (const ColorGrid::Quad& quad : estimateExposures(comparisons, {true, true, true}))
        EXPECT_EQ(quad[0].gain, 1);
}

TEST(Gcpw_Exposures, where_no_image_is_fixed_exposures_are_one_on_average)
{
    const Problem problem = chain(false);
    const std::vector<ColorGrid::Quad> found = estimateExposures(compareColors(overlapsOf(problem), roughStates(problem)), {false, false, false});
    double log_gain = 0;
    double bias = 0;
    for (const ColorGrid::Quad& quad : found)
    {
        log_gain += std::log(quad[0].gain);
        bias += quad[0].bias;
    }
    EXPECT_NEAR(log_gain, 0, 1e-6);
    EXPECT_NEAR(bias, 0, 1e-6);
    EXPECT_NEAR(found[1][0].gain / found[0][0].gain, GAINS[0] / GAINS[1], 0.03 * GAINS[0] / GAINS[1]);
}

TEST(Gcpw_Exposures, misalignment_hardly_matters)
{
    const Problem problem = chain(true);
    std::vector<ImageState> states = roughStates(problem);
    for (Point2d& vertex : states[1].mesh.vertices())
        vertex += Point2d(6, -5);
    const std::vector<ColorGrid::Quad> found = estimateExposures(compareColors(overlapsOf(problem), states), {true, false, false});
    for (int i = 1; i < 3; ++i)
        EXPECT_NEAR(found[i][0].gain, 1 / GAINS[i], 0.15 / GAINS[i]);
}

TEST(Gcpw_ColorPriors, quads_without_samples_take_the_exposure_of_their_image)
{
    const Problem problem = chain(true);
    const std::vector<ImageState> states = roughStates(problem);
    const std::vector<ColorComparison> comparisons = compareColors(overlapsOf(problem), states);
    const std::vector<ColorGrid::Quad> exposures = estimateExposures(comparisons, {true, false, false});
    ColorSystem system({LATTICE, LATTICE, LATTICE}, {true, false, false});
    const ImagePriors at_exposures{std::vector<double>(3, 1), exposures};
    const std::vector<ColorPriors> priors = colorPriors(comparisons, {LATTICE, LATTICE, LATTICE}, at_exposures, at_exposures);
    for (int i = 0; i < 3; ++i)
        ColorPriorTerm(i, priors[i]).addTo(system);
    std::vector<ColorGrid> grids(3, ColorGrid(LATTICE));
    ASSERT_EQ(system.solve(grids), SolveStatus::Solved);
    for (int i = 1; i < 3; ++i)
        for (int cell = 0; cell < LATTICE.cellCount(); ++cell)
        {
            EXPECT_NEAR(grids[i].quad(cell)[0].gain, exposures[i][0].gain, 1e-3);
            EXPECT_NEAR(grids[i].quad(cell)[0].bias, exposures[i][0].bias, 1e-3);
        }
}

TEST(Gcpw_ColorPriors, quads_that_are_compared_have_one_prior_and_the_others_another)
{
    const Problem problem = chain(true);
    const std::vector<ColorComparison> comparisons = compareColors(overlapsOf(problem), roughStates(problem));
    const std::vector<ColorGrid::Quad> identity(3);
    const std::vector<ColorPriors> priors =
        colorPriors(comparisons, {LATTICE, LATTICE, LATTICE}, {{2, 3, 4}, identity}, {{0.2, 0.3, 0.4}, identity});
    for (int cell = 0; cell < LATTICE.cellCount(); ++cell)
    {
        const bool right_half = cell % LATTICE.cols() >= LATTICE.cols() / 2;
        EXPECT_EQ(priors[0][cell].weight, right_half ? 2 : 0.2) << cell;
        EXPECT_EQ(priors[2][cell].weight, right_half ? 0.4 : 4) << cell;
        EXPECT_EQ(priors[1][cell].weight, 3) << cell;
    }
}

}} // namespace
