// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#include "test_precomp.hpp"

#include <cstring>
#include "scene.hpp"

namespace opencv_test { namespace {

using namespace cv::gcpw;

const double BOUND = 0.1;        // px, mean over the overlap
const double NOISY_BOUND = 0.25; // px, at two gray levels of noise

/// The scenes' bars are bent in one of their images: that straight lines are straight is not their truth.
Params with(Method method)
{
    Params params = Params::alignmentOnly();
    params.method = method;
    return params;
}

/// Mean error of an alignment on a scene; a failed one is as wrong as can be.
double errorOf(const Scene& scene, const Params& params)
{
    const Alignment alignment = alignPair(scene.source(), scene.target(), params);
    return alignment.ok() ? scene.meanError(alignment.image(0).mesh) : 1e6;
}

double errorOf(const Scene& scene, Method method)
{
    return errorOf(scene, with(method));
}

/// MFW without the additions that give the matches the last word where its pixels mislead it.
Params bareMfw()
{
    Params params = with(Method::MFW);
    params.anchorWeight = 0;
    return params;
}

SceneOptions recoloredScene(double noise)
{
    SceneOptions options;
    options.recolored = true;
    options.noise = noise;
    return options;
}

/// Large enough that nothing but the default working resolution is in play.
SceneOptions atWorkingResolution(SceneOptions options)
{
    options.source_size = options.target_size = Size(880, 660);
    options.rough = slightHomography(170);
    return options;
}

bool sameBits(const Mat& a, const Mat& b)
{
    return a.size() == b.size() && a.type() == b.type() && a.isContinuous() && b.isContinuous() &&
           std::memcmp(a.data, b.data, a.total() * a.elemSize()) == 0;
}

bool sameBits(const Alignment& a, const Alignment& b)
{
    return a.ok() && b.ok() && sameBits(a.image(0).mesh, b.image(0).mesh) &&
           sameBits(a.image(0).color, b.image(0).color);
}

TEST(Gcpw_Pair, truth_is_found_to_a_tenth_of_a_pixel_without_noise)
{
    const Scene scene{SceneOptions()};
    EXPECT_GT(errorOf(scene, Method::GLOBAL), 1.0) << "the scene asks for nothing";
    EXPECT_LE(errorOf(scene, Method::MFW), BOUND);
    EXPECT_LE(errorOf(scene, Method::GCPW), BOUND);
}

TEST(Gcpw_Pair, truth_that_is_a_mesh_is_found_to_a_tenth_of_a_pixel)
{
    SceneOptions options;
    options.mesh_cells = 8;
    options.seed = 2;
    EXPECT_LE(errorOf(Scene(options), Method::GCPW), BOUND);
}

TEST(Gcpw_Pair, truth_is_found_to_a_quarter_of_a_pixel_at_two_gray_levels_of_noise)
{
    SceneOptions options;
    options.noise = 2;
    const Scene scene(options);
    EXPECT_LE(errorOf(scene, Method::MFW), NOISY_BOUND);
    EXPECT_LE(errorOf(scene, Method::GCPW), NOISY_BOUND);
}

TEST(Gcpw_Pair, gcpw_keeps_the_bound_where_gain_and_bias_vary_and_mfw_does_not)
{
    const int scenes = 3;
    double error = 0;
    for (int k = 0; k < scenes; ++k)
    {
        SceneOptions options = recoloredScene(0);
        options.seed += static_cast<uint64_t>(k);
        const Scene scene(options);
        error += errorOf(scene, Method::GCPW) / scenes;
        EXPECT_GT(errorOf(scene, Method::MFW), BOUND);
        EXPECT_GT(errorOf(scene, bareMfw()), 5 * BOUND);
    }
    EXPECT_LE(error, BOUND) << "in the mean";
}

TEST(Gcpw_Pair, gcpw_keeps_the_noisy_bound_where_gain_and_bias_vary_and_mfw_does_not)
{
    const Scene scene(recoloredScene(2));
    EXPECT_LE(errorOf(scene, Method::GCPW), NOISY_BOUND);
    EXPECT_GT(errorOf(scene, bareMfw()), NOISY_BOUND);
}

TEST(Gcpw_Pair, at_the_working_resolution_the_bounds_hold_where_blue_green_and_red_change_each_on_its_own)
{
    SceneOptions options = atWorkingResolution(recoloredScene(0));
    options.tinted = true;
    EXPECT_LE(errorOf(Scene(options), Method::GCPW), BOUND);
    options.noise = 2;
    EXPECT_LE(errorOf(Scene(options), Method::GCPW), NOISY_BOUND);
}

TEST(Gcpw_Pair, the_colors_found_undo_what_was_done_to_the_source)
{
    const Scene scene(recoloredScene(0));
    const Alignment alignment = alignPair(scene.source(), scene.target());
    ASSERT_TRUE(alignment.ok());
    const Mat color = alignment.image(0).color;
    double sum = 0;
    int quads = 0;
    for (int row = 0; row < color.rows; ++row)
        for (int col = 0; col < color.cols; ++col)
        {
            const Point2d centre((col + 0.5) * 480.0 / color.cols - 0.5, (row + 0.5) * 360.0 / color.rows - 0.5);
            if (!scene.insideTarget(scene.canvasAt(centre), 20))
                continue;
            Vec3d gain;
            Vec3d bias;
            scene.colorAt(centre, gain, bias);
            const float* found = color.ptr<float>(row) + 6 * col;
            // Gain and bias may compensate each other: compared at the texture's mean intensity. All channels alike.
            sum += std::abs(found[0] * (gain[0] * 0.425 + bias[0]) + found[3] - 0.425);
            ++quads;
        }
    EXPECT_GT(quads, color.rows * color.cols / 2);
    EXPECT_LT(sum / quads, 0.015);
    EXPECT_LT(alignment.report().gain_min, 0.9);
    EXPECT_GT(alignment.report().gain_max, 1.1);
}

TEST(Gcpw_Pair, energy_never_rises_within_a_level)
{
    const Scene scene(recoloredScene(2));
    for (const Method method : {Method::CPW, Method::DFW, Method::MFW, Method::GCPW})
    {
        const Alignment alignment = alignPair(scene.source(), scene.target(), with(method));
        ASSERT_TRUE(alignment.ok());
        EXPECT_FALSE(alignment.report().levels.empty());
        for (const LevelReport& level : alignment.report().levels)
        {
            EXPECT_GT(totalEnergy(level.start), 0);
            EXPECT_LE(totalEnergy(level.end), totalEnergy(level.start));
            EXPECT_GT(level.iterations, 0);
        }
    }
}

TEST(Gcpw_Pair, a_method_reports_energy_only_of_the_terms_it_has)
{
    const Scene scene{SceneOptions()};
    for (const Method method : {Method::CPW, Method::DFW, Method::MFW, Method::GCPW})
    {
        const Alignment alignment = alignPair(scene.source(), scene.target(), with(method));
        ASSERT_TRUE(alignment.ok());
        const auto has = [&](const char* name)
        {
            for (const TermEnergy& energy : alignment.report().levels.back().end)
                if (energy.name == name)
                    return energy.value > 0;
            return false;
        };
        EXPECT_TRUE(has("points"));
        EXPECT_TRUE(has("similarity"));
        EXPECT_EQ(has("lines"), method >= Method::DFW);
        EXPECT_EQ(has("photometric"), method >= Method::MFW);
        EXPECT_EQ(has("color_smoothness"), method >= Method::GCPW);
        EXPECT_EQ(has("color_prior"), method >= Method::GCPW);
    }
}

TEST(Gcpw_Pair, no_method_folds_a_quad_even_behind_occluders)
{
    SceneOptions options;
    options.occluder = true;
    options.recolored = true;
    options.displacement_px = 16;
    const Scene scene(options);
    for (const Method method : {Method::GLOBAL, Method::CPW, Method::DFW, Method::MFW, Method::GCPW})
    {
        const Alignment alignment = alignPair(scene.source(), scene.target(), with(method));
        ASSERT_TRUE(alignment.ok()) << alignment.report().message;
        EXPECT_EQ(alignment.report().folds, 0) << "method " << static_cast<int>(method);
        // Counted here again: a report may say what it likes.
        const Mat mesh = alignment.image(0).mesh;
        for (int row = 0; row + 1 < mesh.rows; ++row)
            for (int col = 0; col + 1 < mesh.cols; ++col)
            {
                const Vec2d origin = mesh.at<Vec2d>(row, col);
                const Vec2d right = mesh.at<Vec2d>(row, col + 1) - origin;
                const Vec2d down = mesh.at<Vec2d>(row + 1, col) - origin;
                ASSERT_GT(right[0] * down[1] - right[1] * down[0], 0) << row << " " << col;
            }
    }
}

TEST(Gcpw_Pair, global_leaves_the_rough_alignment_and_others_do_not)
{
    const Scene scene{SceneOptions()};
    const Alignment global = alignPair(scene.source(), scene.target(), with(Method::GLOBAL));
    ASSERT_TRUE(global.ok());
    EXPECT_TRUE(sameBits(global.image(0).mesh, global.image(0).rough));
    EXPECT_EQ(global.report().max_displacement_px, 0);
    const Alignment warped = alignPair(scene.source(), scene.target(), with(Method::CPW));
    ASSERT_TRUE(warped.ok());
    EXPECT_GT(warped.report().max_displacement_px, 2);
    EXPECT_TRUE(sameBits(warped.image(0).rough, global.image(0).rough));
}

TEST(Gcpw_Pair, one_thread_and_many_give_the_same_bits)
{
    const Scene scene(recoloredScene(0));
    const int threads = getNumThreads();
    setNumThreads(2);
    const Alignment many = alignPair(scene.source(), scene.target());
    setNumThreads(1);
    const Alignment one = alignPair(scene.source(), scene.target());
    setNumThreads(threads);
    EXPECT_TRUE(sameBits(one, many));
}

TEST(Gcpw_Pair, the_same_call_gives_the_same_bits)
{
    SceneOptions options;
    options.noise = 2;
    const Scene scene(options);
    EXPECT_TRUE(sameBits(alignPair(scene.source(), scene.target()), alignPair(scene.source(), scene.target())));
}

TEST(Gcpw_Pair, the_same_photograph_twice_stays_where_it_is)
{
    const Scene scene{SceneOptions()};
    const Alignment alignment = alignPair(scene.target(), scene.target());
    ASSERT_TRUE(alignment.ok());
    const Mat reference = alignment.image(1).mesh; // the target is fixed and undeformed
    EXPECT_LT(cv::norm(alignment.image(0).mesh, reference, NORM_INF), 0.05);
    EXPECT_NEAR(alignment.report().gain_min, 1, 0.02);
    EXPECT_NEAR(alignment.report().gain_max, 1, 0.02);
    ASSERT_EQ(alignment.report().pairs.size(), 1u);
    EXPECT_LT(alignment.report().pairs[0].miss_before, 1);
    EXPECT_LT(alignment.report().pairs[0].miss_after, 1);
}

TEST(Gcpw_Pair, the_report_says_that_the_alignment_became_better)
{
    const Scene scene{SceneOptions()};
    const Alignment alignment = alignPair(scene.source(), scene.target());
    ASSERT_TRUE(alignment.ok());
    ASSERT_EQ(alignment.report().pairs.size(), 1u);
    const PairReport& pair = alignment.report().pairs[0];
    EXPECT_GT(pair.points, 100);
    EXPECT_GT(pair.lines, 5);
    EXPECT_GT(pair.miss_before, 10);
    EXPECT_LT(pair.miss_after, 0.2 * pair.miss_before);
}

TEST(Gcpw_Pair, the_papers_own_constants_find_the_truth_too)
{
    EXPECT_LE(errorOf(Scene(SceneOptions()), Params::paper()), NOISY_BOUND);
    EXPECT_LE(errorOf(Scene(recoloredScene(0)), Params::paper()), NOISY_BOUND);
}

}} // namespace
