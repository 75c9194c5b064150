// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#include "test_precomp.hpp"

#include <opencv2/imgproc.hpp>
#include "imaging/pyramid.hpp"
#include "color/color_balance.hpp"
#include "color/exposures.hpp"
#include "color/tone_limits.hpp"
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
    std::vector<PyramidLevel> levels;

    Trio(const std::vector<double>& gains, const std::vector<double>& biases, bool one_scene)
    {
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

    std::vector<ColorGrid> balanced(int reference = -1, const Params& params = Params()) const
    {
        return balancedColors(levels, overlaps, states, reference, params);
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

TEST(Gcpw_ColorBalance, photographs_of_one_scene_agree_with_the_reference)
{
    const Trio trio({1, 0.7, 1.2}, {0, 0.08, -0.05}, true);
    const std::vector<ColorGrid> untouched(3, ColorGrid(LATTICE));
    const std::vector<ColorGrid> colors = trio.balanced(0);
    EXPECT_GT(trio.difference(untouched), 0.03);
    EXPECT_LT(trio.difference(colors), 0.003);
    for (int cell = 0; cell < LATTICE.cellCount(); ++cell)
        EXPECT_NEAR(colors[1].quad(cell)[0].gain / colors[0].quad(cell)[0].gain, 1 / 0.7, 0.1);
}

TEST(Gcpw_ColorBalance, without_a_reference_they_come_closer_and_black_stays_black)
{
    const Trio trio({1, 0.7, 0.9}, {0, 0.08, 0}, true);
    const std::vector<ColorGrid> colors = trio.balanced();
    EXPECT_LT(trio.difference(colors), 0.4 * trio.difference(std::vector<ColorGrid>(3, ColorGrid(LATTICE))));
    for (const ColorGrid& grid : colors)
        for (int cell = 0; cell < LATTICE.cellCount(); ++cell)
            EXPECT_LT(grid.quad(cell)[0].bias, 8.0 / 255) << cell;
}

TEST(Gcpw_ColorBalance, shared_lights_go_a_share_of_the_way_and_leave_black_black)
{
    const Trio trio({1, 0.5, 1}, {0, 0, 0}, true);
    const std::vector<ColorGrid::Quad> lights = sharedLights(compareColors(trio.overlaps, trio.states), 3);
    for (int c = 0; c < 3; ++c)
        EXPECT_NEAR(lights[1][c].gain / lights[0][c].gain, std::pow(2, 0.3), 0.05) << c;
    for (const ColorGrid::Quad& light : lights)
    {
        EXPECT_EQ(light[0].bias, 0);
        for (int c = 1; c < 3; ++c)
            EXPECT_NEAR(light[c].gain * 128 / 255 + light[c].bias, 128.0 / 255, 0.01) << "gray of channel " << c;
    }
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
    params.balanceWeight = 0.01;
    params.colorSmoothnessWeight = 0.1;
    const std::vector<ColorGrid> colors = trio.balanced(0, params);
    EXPECT_LT(trio.difference(colors), 0.01);
    EXPECT_NEAR(colors[1].quad(1)[0].gain / colors[1].quad(5 * 8 + 1)[0].gain, 1.33 / 0.67, 0.3);
}

TEST(Gcpw_ColorBalance, contrast_stays_where_photographs_show_different_things)
{
    const Trio trio({1, 1, 1}, {0, 0, 0}, false);
    const std::vector<ColorGrid> colors = trio.balanced();
    for (int c = 0; c < 3; ++c)
        EXPECT_NEAR(meanGain(colors, c), 1, 0.1) << c;
}

TEST(Gcpw_ColorBalance, no_image_is_privileged_unless_asked_for)
{
    const Trio trio({1, 0.7, 1.2}, {0, 0.08, -0.05}, true);
    EXPECT_NEAR(meanGain(trio.balanced(), 0), 1, 0.05);
    const std::vector<ColorGrid> colors = trio.balanced(1);
    EXPECT_TRUE(colors[1].isIdentity());
    EXPECT_NEAR(colors[0].quad(20)[0].gain, 0.7, 0.05);
    EXPECT_LT(trio.difference(colors), 0.003);
}

TEST(Gcpw_ColorBalance, colours_at_the_start_do_not_matter)
{
    Trio trio({1, 0.7, 1.2}, {0, 0.08, -0.05}, true);
    const std::vector<ColorGrid> colors = trio.balanced();
    for (ImageState& state : trio.states)
        for (int cell = 0; cell < LATTICE.cellCount(); ++cell)
            state.color.quad(cell)[0] = {0.5, 0.2};
    const std::vector<ColorGrid> again = trio.balanced();
    for (int i = 0; i < 3; ++i)
        EXPECT_EQ(cv::norm(colors[i].toMat(), again[i].toMat(), NORM_INF), 0);
}

TEST(Gcpw_ColorBalance, with_nothing_to_compare_every_image_keeps_its_colours)
{
    const Trio trio({1, 0.7, 1.2}, {0, 0, 0}, true);
    for (const ColorGrid& grid : balancedColors(trio.levels, {}, trio.states, -1, Params()))
        EXPECT_LT(cv::norm(grid.toMat(), ColorGrid(LATTICE).toMat(), NORM_INF), 1e-6);
}

/// Two photographs of one scene, the second from 60 px farther right; what they show can be painted over.
struct Two
{
    Mat images[2];
    std::vector<ImageState> states;

    explicit Two(int contrast = 200)
    {
        for (int i = 0; i < 2; ++i)
        {
            images[i].create(SIZE, CV_8UC3);
            for (int y = 0; y < SIZE.height; ++y)
                for (int x = 0; x < SIZE.width; ++x)
                    images[i].at<Vec3b>(y, x) = Vec3b(contrast * Texture(8).at(Point2d(60 * i + x, y)) + Vec3d::all(30));
            ImageState state;
            state.mesh = MeshGrid(LATTICE, Point2d(60 * i, 0));
            state.color = ColorGrid(LATTICE);
            states.push_back(state);
        }
    }

    std::vector<ColorGrid> balanced(int reference = -1) const
    {
        std::vector<PyramidLevel> levels;
        for (const Mat& image : images)
            levels.push_back(buildPyramid(image, Mat(), 1)[0]);
        return balancedColors(levels, {OverlapSamples(1, 0, levels[1], levels[0], LATTICE, 2)}, states, reference, Params());
    }

    /// The photographs as the colours change them, quad by quad, Y, Cr, Cb in gray levels.
    Mat shown(int image, const std::vector<ColorGrid>& colors) const
    {
        Mat result;
        cvtColor(images[image], result, COLOR_BGR2YCrCb);
        result.convertTo(result, CV_64F);
        for (int y = 0; y < SIZE.height; ++y)
            for (int x = 0; x < SIZE.width; ++x)
                for (int c = 0; c < 3; ++c)
                {
                    const ChannelAffine& map = colors[image].quad(LATTICE.locate(Point2d(x, y)).cell)[c];
                    double& value = result.at<Vec3d>(y, x)[c];
                    value = map.gain * value + 255 * map.bias;
                }
        return result;
    }

    Scalar meanShown(const std::vector<ColorGrid>& colors) const { return 0.5 * (mean(shown(0, colors)) + mean(shown(1, colors))); }
};

TEST(Gcpw_ColorBalance, what_only_one_photograph_shows_tints_neither)
{
    for (const int side : {12, 40})
        for (const Scalar& color : {Scalar(0, 0, 255), Scalar(255, 0, 0), Scalar::all(0), Scalar::all(255), Scalar(30, 160, 230)})
        {
            Two two;
            two.images[1](Rect(30, 30, side, side)).setTo(color);
            const std::vector<ColorGrid> colors = two.balanced();
            for (int i = 0; i < 2; ++i)
                EXPECT_LT(cv::norm(two.shown(i, colors), two.shown(i, std::vector<ColorGrid>(2, ColorGrid(LATTICE))), NORM_INF), 1) << side << color;
        }
}

TEST(Gcpw_ColorBalance, a_known_gain_is_found_beside_what_only_one_photograph_shows)
{
    Two two;
    two.images[1].convertTo(two.images[1], CV_8U, 0.75);
    two.images[1](Rect(30, 30, 40, 40)).setTo(Scalar(0, 0, 255));
    const std::vector<ColorGrid> colors = two.balanced(0);
    EXPECT_TRUE(colors[0].isIdentity());
    const ChannelAffine& luma = colors[1].quad(4 * LATTICE.cols() + 1)[0];
    EXPECT_NEAR(luma.gain * 90 / 255 + luma.bias, 120.0 / 255, 2.0 / 255);
}

TEST(Gcpw_ColorBalance, the_panorama_keeps_the_mean_light_and_hue_of_its_photographs)
{
    Two two;
    two.images[1].convertTo(two.images[1], CV_8U, 0.6);
    cv::add(two.images[1], Scalar(20, 0, 10), two.images[1]);
    const Scalar before = two.meanShown(std::vector<ColorGrid>(2, ColorGrid(LATTICE)));
    const Scalar after = two.meanShown(two.balanced());
    for (int c = 0; c < 3; ++c)
        EXPECT_NEAR(before[c], after[c], 0.5) << c;
}

TEST(Gcpw_ColorBalance, a_gray_photograph_tints_none_and_stays_gray)
{
    Two two;
    Mat gray;
    cvtColor(two.images[1], gray, COLOR_BGR2GRAY);
    cvtColor(0.8 * gray, two.images[1], COLOR_GRAY2BGR);
    for (const ColorGrid& grid : two.balanced())
        for (int cell = 0; cell < LATTICE.cellCount(); ++cell)
            for (int c = 1; c < 3; ++c)
            {
                EXPECT_NEAR(grid.quad(cell)[c].gain, 1, 1e-6);
                EXPECT_NEAR(grid.quad(cell)[c].bias, 0, 1e-6);
            }
}

TEST(Gcpw_ColorBalance, shadows_of_the_brighter_photograph_are_not_lost)
{
    Two two;
    two.images[1].convertTo(two.images[1], CV_8U, 0.5);
    // Away from the other.
    for (int x = 0; x < 50; ++x)
        two.images[0].col(x).setTo(Scalar::all(25 + x % 20));
    const std::vector<ColorGrid> colors = two.balanced();
    Mat luma;
    extractChannel(two.shown(0, colors), luma, 0);
    EXPECT_LE(countNonZero(luma.colRange(0, 50) < 23.5), 0.005 * 2 * SIZE.area());
}

TEST(Gcpw_ColorBalance, highlights_of_the_darker_photograph_are_not_lost)
{
    Two two;
    two.images[0].convertTo(two.images[0], CV_8U, 0.5);
    // Away from the other.
    for (int x = 0; x < 50; ++x)
        two.images[0].col(x).setTo(Scalar::all(249 - x % 20));
    const std::vector<ColorGrid> colors = two.balanced();
    Mat luma;
    extractChannel(two.shown(0, colors), luma, 0);
    EXPECT_LE(countNonZero(luma.colRange(0, 50) > 250.5), 0.005 * 2 * SIZE.area());
}

TEST(Gcpw_ColorBalance, limits_leave_colours_that_crush_and_blow_nothing)
{
    const Two two(100);
    const PhotographTone tone(buildPyramid(two.images[0], Mat(), 1)[0], LATTICE);
    ColorGrid colors(LATTICE);
    limitExtremes(tone, colors);
    EXPECT_TRUE(colors.isIdentity());
    for (int cell = 0; cell < LATTICE.cellCount(); ++cell)
        colors.quad(cell)[0] = {1.2, 0};
    const Mat before = colors.toMat();
    limitExtremes(tone, colors);
    EXPECT_EQ(cv::norm(before, colors.toMat(), NORM_INF), 0);
}

TEST(Gcpw_ColorBalance, limits_hold_for_colours_that_would_crush_or_blow)
{
    const Two two;
    const PhotographTone tone(buildPyramid(two.images[0], Mat(), 1)[0], LATTICE);
    for (const ChannelAffine& map : {ChannelAffine{0.5, 0}, ChannelAffine{1.6, 0}, ChannelAffine{1.5, -0.15}})
    {
        std::vector<ColorGrid> colors(1, ColorGrid(LATTICE));
        for (int cell = 0; cell < LATTICE.cellCount(); ++cell)
            colors[0].quad(cell)[0] = map;
        limitExtremes(tone, colors[0]);
        Mat luma;
        extractChannel(two.shown(0, colors), luma, 0);
        EXPECT_LE(countNonZero(luma < 23.5), 0.005 * SIZE.area()) << map.gain;
        EXPECT_LE(countNonZero(luma > 250.5), 0.005 * SIZE.area()) << map.gain;
    }
}

TEST(Gcpw_ColorBalance, clipped_pixels_do_not_decide_on_the_light)
{
    Two two;
    two.images[1].convertTo(two.images[1], CV_8U, 0.75);
    // Half of the overlap, too bright for both: equal there, though the light is not.
    two.images[0](Rect(60, 0, 100, 50)).setTo(Scalar::all(255));
    two.images[1](Rect(0, 0, 100, 50)).setTo(Scalar::all(255));
    const std::vector<ColorGrid> colors = two.balanced(0);
    const ChannelAffine& luma = colors[1].quad(4 * LATTICE.cols() + 2)[0];
    EXPECT_NEAR(luma.gain * 90 / 255 + luma.bias, 120.0 / 255, 3.0 / 255);
}

}} // namespace
