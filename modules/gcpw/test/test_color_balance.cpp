// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#include "test_precomp.hpp"

#include "imaging/pyramid.hpp"
#include "color/color_balance.hpp"
#include "overlap/color_comparison.hpp"
#include "scene.hpp"

namespace opencv_test { namespace {

using namespace cv::gcpw;

const Size SIZE(160, 120);
const Lattice LATTICE(SIZE, 8, 6);
const Point2d ORIGINS[3] = {{0, 0}, {60, 0}, {20, 40}};

/// Three photographs that overlap pairwise, darker and lighter; of one scene or of three.
struct Trio
{
    std::vector<ImageState> states;
    std::vector<OverlapSamples> overlaps;

    Trio(const std::vector<double>& gains, const std::vector<double>& biases, bool one_scene)
    {
        std::vector<PyramidLevel> levels;
        for (int i = 0; i < 3; ++i)
        {
            const Texture texture(one_scene ? 8 : 8 + i);
            Mat image(SIZE, CV_8UC3);
            for (int y = 0; y < SIZE.height; ++y)
                for (int x = 0; x < SIZE.width; ++x)
                    image.at<Vec3b>(y, x) = Vec3b(255.0 * (gains[i] * texture.at(ORIGINS[i] + Point2d(x, y)) + Vec3d::all(biases[i])));
            levels.push_back(buildPyramid(image, Mat(), 1)[0]);
            ImageState state;
            state.mesh = MeshGrid(LATTICE, ORIGINS[i]);
            state.color = ColorGrid(LATTICE);
            states.push_back(state);
        }
        for (int i = 0; i < 3; ++i)
            for (int k = 0; k < i; ++k)
                overlaps.emplace_back(i, k, levels[i], levels[k], LATTICE, 3);
    }

    /// Mean luma difference of the corrected photographs where they overlap.
    double difference(const std::vector<ColorGrid>& colors) const
    {
        double sum = 0;
        double count = 0;
        for (const OverlapSamples& samples : overlaps)
            for (const QuadColors& quads : compareColors(samples, states).quads)
            {
                const ChannelAffine& a = colors[samples.sourceImage()].quad(quads.source_cell)[0];
                const ChannelAffine& b = colors[samples.targetImage()].quad(quads.target_cell)[0];
                const ColorMoments& m = quads.moments;
                sum += m.samples() * std::abs(a.gain * m.sourceMean(0) + a.bias - b.gain * m.targetMean(0) - b.bias);
                count += m.samples();
            }
        return sum / count;
    }
};

double meanGain(const std::vector<ColorGrid>& colors, int channel)
{
    double sum = 0;
    for (const ColorGrid& grid : colors)
        for (int cell = 0; cell < LATTICE.cellCount(); ++cell)
            sum += grid.quad(cell)[channel].gain;
    return sum / (static_cast<double>(colors.size()) * LATTICE.cellCount());
}

TEST(Gcpw_ColorBalance, photographs_of_one_scene_agree_afterwards)
{
    const Trio trio({1, 0.7, 1.2}, {0, 0.08, -0.05}, true);
    const std::vector<ColorGrid> untouched(3, ColorGrid(LATTICE));
    const std::vector<ColorGrid> colors = balancedColors(trio.overlaps, trio.states, Params());
    EXPECT_GT(trio.difference(untouched), 0.03);
    EXPECT_LT(trio.difference(colors), 0.003);
    for (int cell = 0; cell < LATTICE.cellCount(); ++cell)
        EXPECT_NEAR(colors[1].quad(cell)[0].gain / colors[0].quad(cell)[0].gain, 1 / 0.7, 0.1);
}

TEST(Gcpw_ColorBalance, a_light_that_varies_over_a_photograph_is_followed)
{
    Trio trio({1, 1, 1}, {0, 0, 0}, true);
    Mat images[2] = {Mat(SIZE, CV_8UC3), Mat(SIZE, CV_8UC3)};
    for (int y = 0; y < SIZE.height; ++y)
        for (int x = 0; x < SIZE.width; ++x)
            for (int i = 0; i < 2; ++i)
                images[i].at<Vec3b>(y, x) = Vec3b((i == 0 ? 1 : 0.6 + 0.8 * y / SIZE.height) * 255.0 *
                                                  Texture(8).at(ORIGINS[i] + Point2d(x, y)));
    trio.overlaps.assign(1, OverlapSamples(1, 0, buildPyramid(images[1], Mat(), 1)[0], buildPyramid(images[0], Mat(), 1)[0], LATTICE, 3));
    Params params;
    params.referenceImage = 0;
    params.balanceWeight = 0.01;
    params.colorSmoothnessWeight = 0.1;
    const std::vector<ColorGrid> colors = balancedColors(trio.overlaps, trio.states, params);
    EXPECT_LT(trio.difference(colors), 0.01);
    EXPECT_NEAR(colors[1].quad(1)[0].gain / colors[1].quad(5 * 8 + 1)[0].gain, 1.33 / 0.67, 0.3);
}

TEST(Gcpw_ColorBalance, contrast_stays_where_photographs_show_different_things)
{
    const Trio trio({1, 1, 1}, {0, 0, 0}, false);
    const std::vector<ColorGrid> colors = balancedColors(trio.overlaps, trio.states, Params());
    for (int c = 0; c < 3; ++c)
        EXPECT_NEAR(meanGain(colors, c), 1, 0.1) << c;
}

TEST(Gcpw_ColorBalance, no_image_is_privileged_unless_asked_for)
{
    const Trio trio({1, 0.7, 1.2}, {0, 0.08, -0.05}, true);
    Params params;
    EXPECT_NEAR(meanGain(balancedColors(trio.overlaps, trio.states, params), 0), 1, 0.05);
    params.referenceImage = 1;
    const std::vector<ColorGrid> colors = balancedColors(trio.overlaps, trio.states, params);
    EXPECT_TRUE(colors[1].isIdentity());
    EXPECT_NEAR(colors[0].quad(20)[0].gain, 0.7, 0.05);
    EXPECT_LT(trio.difference(colors), 0.003);
}

TEST(Gcpw_ColorBalance, colours_at_the_start_do_not_matter)
{
    Trio trio({1, 0.7, 1.2}, {0, 0.08, -0.05}, true);
    const std::vector<ColorGrid> colors = balancedColors(trio.overlaps, trio.states, Params());
    for (ImageState& state : trio.states)
        for (int cell = 0; cell < LATTICE.cellCount(); ++cell)
            state.color.quad(cell)[0] = {0.5, 0.2};
    const std::vector<ColorGrid> again = balancedColors(trio.overlaps, trio.states, Params());
    for (int i = 0; i < 3; ++i)
        EXPECT_EQ(cv::norm(colors[i].toMat(), again[i].toMat(), NORM_INF), 0);
}

TEST(Gcpw_ColorBalance, with_nothing_to_compare_every_image_keeps_its_colours)
{
    const Trio trio({1, 0.7, 1.2}, {0, 0, 0}, true);
    for (const ColorGrid& grid : balancedColors({}, trio.states, Params()))
        EXPECT_LT(cv::norm(grid.toMat(), ColorGrid(LATTICE).toMat(), NORM_INF), 1e-6);
}

}} // namespace
