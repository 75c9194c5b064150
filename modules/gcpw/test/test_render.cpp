// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#include "test_precomp.hpp"

#include "refusal.hpp"
#include "scene.hpp"

namespace opencv_test { namespace {

using namespace cv::gcpw;

/// Mean absolute difference, gray levels, where both images have content; 5 px from their borders.
double differenceInOverlap(const Mat& a, const Mat& b, const PairCanvas& canvas)
{
    Mat inside;
    cv::erode(canvas.source_mask & canvas.target_mask, inside, Mat::ones(11, 11, CV_8U), Point(-1, -1), 1,
              BORDER_CONSTANT, Scalar(0));
    return cv::norm(a, b, NORM_L1, inside) / (3.0 * countNonZero(inside));
}

TEST(Gcpw_Render, all_pictures_have_one_size_and_the_target_is_only_translated)
{
    const Scene scene{smallScene()};
    const PairCanvas canvas = renderPair(alignPair(scene.source(), scene.target()), scene.source(), scene.target());
    for (const Mat& picture : {canvas.source, canvas.source_corrected, canvas.target, canvas.mesh})
    {
        EXPECT_EQ(picture.type(), CV_8UC3);
        EXPECT_EQ(picture.size(), canvas.target.size());
    }
    for (const Mat& mask : {canvas.source_mask, canvas.target_mask})
    {
        EXPECT_EQ(mask.type(), CV_8UC1);
        EXPECT_EQ(mask.size(), canvas.target.size());
    }
    const Rect place(canvas.target_origin, scene.target().size());
    EXPECT_EQ(cv::norm(canvas.target(place), scene.target(), NORM_INF), 0);
    EXPECT_EQ(countNonZero(canvas.target_mask), place.area());
    EXPECT_EQ(countNonZero(canvas.target_mask(place)), place.area());
}

TEST(Gcpw_Render, the_rendered_source_shows_what_the_target_shows)
{
    const Scene scene{smallScene()};
    const Alignment alignment = alignPair(scene.source(), scene.target());
    const PairCanvas canvas = renderPair(alignment, scene.source(), scene.target());
    EXPECT_LT(differenceInOverlap(canvas.source, canvas.target, canvas), 1.5);
    EXPECT_GT(countNonZero(canvas.source_mask & canvas.target_mask), 320 * 240 / 2);
    EXPECT_LT(scorePair(canvas).zncc, 3);
}

TEST(Gcpw_Render, the_source_is_masked_exactly_where_its_true_pixels_end)
{
    const Scene scene{smallScene()};
    const PairCanvas canvas = renderPair(alignPair(scene.source(), scene.target()), scene.source(), scene.target());
    Mat border = canvas.source_mask.clone();
    for (int y = 2; y < 238; y += 5)
        for (int x = 2; x < 318; x += 5)
        {
            const Point2d p = scene.canvasAt(Point2d(x, y));
            if (!scene.insideTarget(p, 1)) // beyond the target nothing tells how the mesh should lie
                continue;
            const Point at(cvRound(p.x) + canvas.target_origin.x, cvRound(p.y) + canvas.target_origin.y);
            ASSERT_EQ(canvas.source_mask.at<uchar>(at), 255) << Point(x, y);
        }
    // A little left of the true border nothing is drawn.
    for (int y = 40; y < 200; y += 10)
    {
        const Point2d p = scene.canvasAt(Point2d(-4, y));
        const Point at(cvRound(p.x) + canvas.target_origin.x, cvRound(p.y) + canvas.target_origin.y);
        EXPECT_EQ(canvas.source_mask.at<uchar>(at), 0);
        EXPECT_EQ(canvas.source.at<Vec3b>(at), Vec3b(0, 0, 0));
    }
}

TEST(Gcpw_Render, corrected_colors_are_those_of_the_target)
{
    SceneOptions options = smallScene();
    options.recolored = true;
    const Scene scene(options);
    const Alignment alignment = alignPair(scene.source(), scene.target());
    const PairCanvas canvas = renderPair(alignment, scene.source(), scene.target());
    EXPECT_GT(differenceInOverlap(canvas.source, canvas.target, canvas), 12);
    EXPECT_LT(differenceInOverlap(canvas.source_corrected, canvas.target, canvas), 4);
}

TEST(Gcpw_Render, colors_stay_untouched_without_a_color_model)
{
    const Scene scene{smallScene()};
    Params params;
    params.method = Method::MFW;
    const PairCanvas canvas =
        renderPair(alignPair(scene.source(), scene.target(), params), scene.source(), scene.target());
    // YCrCb and back rounds.
    EXPECT_LE(cv::norm(canvas.source, canvas.source_corrected, NORM_INF), 3);
}

TEST(Gcpw_Render, one_warp_fits_any_picture_of_the_same_size)
{
    SceneOptions options = smallScene();
    const Scene plain(options);
    options.recolored = true;
    const Scene recolored(options);
    const Alignment alignment = alignPair(recolored.source(), recolored.target());
    const PairCanvas canvas = renderPair(alignment, plain.source(), plain.target());
    EXPECT_LT(differenceInOverlap(canvas.source, canvas.target, canvas), 2);
    EXPECT_THROW(renderPair(alignment, plain.source()(Rect(0, 0, 100, 100)), plain.target()), cv::Exception);
    EXPECT_THROW(renderPair(alignment, plain.source(), plain.target()(Rect(0, 0, 100, 100))), cv::Exception);
}

TEST(Gcpw_Render, nothing_can_be_rendered_without_an_alignment)
{
    const Mat flat(100, 100, CV_8UC3, Scalar::all(9));
    const Alignment none = alignPair(flat, flat);
    ASSERT_EQ(none.report().status, Status::NO_ALIGNMENT);
    EXPECT_THROW(renderPair(none, flat, flat), cv::Exception);
}

TEST(Gcpw_Render, estimating_small_renders_at_full_resolution)
{
    SceneOptions options;
    options.source_size = options.target_size = Size(640, 480);
    options.rough = slightHomography(130);
    const Scene scene(options);
    Params params;
    params.workMegapix = 0.1;
    const Alignment alignment = alignPair(scene.source(), scene.target(), params);
    ASSERT_TRUE(alignment.ok());
    EXPECT_EQ(alignment.image(0).full_size, scene.source().size());
    EXPECT_LT(alignment.image(0).work_size.area(), 101000);
    const PairCanvas canvas = renderPair(alignment, scene.source(), scene.target());
    EXPECT_GT(canvas.target.cols, 640);
    EXPECT_LT(differenceInOverlap(canvas.source, canvas.target, canvas), 2);
}

TEST(Gcpw_Render, average_is_the_mean_in_the_overlap_and_the_picture_itself_elsewhere)
{
    const Scene scene{smallScene()};
    const PairCanvas canvas = renderPair(alignPair(scene.source(), scene.target()), scene.source(), scene.target());
    const Mat panorama = blendPair(canvas, Blend::AVERAGE);
    ASSERT_EQ(panorama.size(), canvas.target.size());
    ASSERT_EQ(panorama.type(), CV_8UC3);
    for (int y = 0; y < panorama.rows; y += 3)
        for (int x = 0; x < panorama.cols; x += 3)
        {
            const bool s = canvas.source_mask.at<uchar>(y, x) != 0;
            const bool t = canvas.target_mask.at<uchar>(y, x) != 0;
            const Vec3d a = canvas.source.at<Vec3b>(y, x);
            const Vec3d b = canvas.target.at<Vec3b>(y, x);
            const Vec3d expected = s && t ? 0.5 * (a + b) : s ? a : t ? b : Vec3d();
            ASSERT_LE(cv::norm(Vec3d(panorama.at<Vec3b>(y, x)) - expected, NORM_INF), 0.5) << Point(x, y);
        }
}

TEST(Gcpw_Render, multiband_shows_both_photographs_without_a_step_of_color)
{
    SceneOptions options = smallScene();
    options.recolored = true;
    const Scene scene(options);
    const PairCanvas canvas = renderPair(alignPair(scene.source(), scene.target()), scene.source(), scene.target());
    const Mat panorama = blendPair(canvas, Blend::MULTIBAND);
    ASSERT_EQ(panorama.size(), canvas.target.size());
    ASSERT_EQ(panorama.type(), CV_8UC3);
    EXPECT_LT(differenceInOverlap(panorama, canvas.target, canvas), 6);
}

TEST(Gcpw_Render, multiband_does_not_mix_in_what_lies_outside_the_masks)
{
    PairCanvas canvas;
    const Size size(300, 200);
    canvas.source_mask = Mat::zeros(size, CV_8UC1);
    canvas.target_mask = Mat::zeros(size, CV_8UC1);
    canvas.source_mask(Rect(100, 20, 200, 150)).setTo(255);
    canvas.target_mask(Rect(0, 50, 180, 150)).setTo(255);
    canvas.source = Mat::zeros(size, CV_8UC3);
    canvas.target = Mat::zeros(size, CV_8UC3);
    const Scalar gray = Scalar::all(140);
    canvas.source.setTo(gray, canvas.source_mask);
    canvas.target.setTo(gray, canvas.target_mask);
    canvas.source_corrected = canvas.source;
    const Mat panorama = blendPair(canvas, Blend::MULTIBAND);
    EXPECT_LE(cv::norm(panorama, Mat(size, CV_8UC3, gray), NORM_INF, canvas.source_mask | canvas.target_mask), 8);
}

TEST(Gcpw_Render, stitching_is_all_of_it_in_one_call_and_leaves_the_output_alone_when_it_fails)
{
    const Scene scene{smallScene()};
    Mat panorama;
    ASSERT_TRUE(stitchPair(scene.source(), scene.target(), panorama, Params(), Blend::AVERAGE));
    const Alignment alignment = alignPair(scene.source(), scene.target());
    const PairCanvas canvas = renderPair(alignment, scene.source(), scene.target(), View::NATURAL);
    EXPECT_EQ(cv::norm(panorama, blendPair(canvas, Blend::AVERAGE), NORM_INF), 0);
    ASSERT_TRUE(stitchPair(scene.source(), scene.target(), panorama, Params(), Blend::AVERAGE, View::TARGET));
    const PairCanvas in_target = renderPair(alignment, scene.source(), scene.target());
    EXPECT_EQ(cv::norm(panorama, blendPair(in_target, Blend::AVERAGE), NORM_INF), 0);

    const Mat flat(100, 100, CV_8UC3, Scalar::all(9));
    const Mat before = panorama.clone();
    EXPECT_FALSE(stitchPair(flat, flat, panorama));
    EXPECT_EQ(cv::norm(panorama, before, NORM_INF), 0);
}

TEST(Gcpw_Render, a_mesh_that_ran_away_makes_no_canvas)
{
    const Scene scene{smallScene()};
    const Alignment alignment = alignPair(scene.source(), scene.target());
    ASSERT_TRUE(alignment.ok());
    for (const double far : {32768.0, 1e6, 2147483647.0, -2147483648.0, 3e9, -3e9, 1e300, -1e300})
        for (int axis = 0; axis < 2; ++axis)
        {
            Alignment::Image source = alignment.image(0);
            source.mesh = source.mesh.clone();
            source.mesh.at<Vec2d>(5, 7)[axis] = far;
            const Alignment broken({source, alignment.image(1)}, alignment.canvasScale(), alignment.report());
            expectRefused([&] { renderPair(broken, scene.source(), scene.target()); }, "the canvas would be");
        }
}

}} // namespace
