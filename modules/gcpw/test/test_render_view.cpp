// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#include "test_precomp.hpp"

#include <cmath>
#include <functional>
#include "camera_turn.hpp"
#include "refusal.hpp"
#include "scene.hpp"

namespace opencv_test { namespace {

using namespace cv::gcpw;

const Size PHOTO(480, 360);

AlignedImage alignedBy(const Matx33d& canvas_from_photo)
{
    AlignedImage image;
    image.full_size = image.work_size = PHOTO;
    const MeshGrid mesh = warpedLattice(Lattice(PHOTO, 32, 32), canvas_from_photo);
    image.mesh.create(33, 33, CV_64FC2);
    for (int i = 0; i < mesh.lattice().vertexCount(); ++i)
        image.mesh.at<Vec2d>(i / 33, i % 33) = Vec2d(mesh.vertices()[i].x, mesh.vertices()[i].y);
    image.rough = image.mesh;
    image.color = Mat::zeros(32, 32, CV_32FC(6));
    for (int row = 0; row < 32; ++row)
        for (int col = 0; col < 32; ++col)
            for (int channel = 0; channel < 3; ++channel)
                image.color.ptr<float>(row)[6 * col + channel] = 1;
    return image;
}

/// What alignPair() would find, were it perfect.
Alignment alignmentBy(const Matx33d& target_from_source)
{
    return {{alignedBy(target_from_source), alignedBy(Matx33d::eye())}, Size2d(1, 1), Report()};
}

/// Both photographs of a picture that is a formula on the target's frame.
Mat photograph(const Matx33d& target_from_photo, const std::function<double(Point2d)>& gray)
{
    Mat image(PHOTO, CV_8UC3);
    for (int y = 0; y < image.rows; ++y)
        for (int x = 0; x < image.cols; ++x)
            image.at<Vec3b>(y, x) = Vec3b::all(saturate_cast<uchar>(gray(applyHomography(target_from_photo, Point2d(x, y)))));
    return image;
}

Point2d onCanvas(const PairCanvas& canvas, Point2d target_px)
{
    return applyHomography(Matx33d(canvas.canvas_from_target.ptr<double>()), target_px);
}

/// Mean absolute difference where both images have content, gray levels.
double differenceInOverlap(const PairCanvas& canvas)
{
    Mat inside;
    cv::erode(canvas.source_mask & canvas.target_mask, inside, Mat::ones(11, 11, CV_8U), Point(-1, -1), 1, BORDER_CONSTANT,
              Scalar(0));
    return cv::norm(canvas.source, canvas.target, NORM_L1, inside) / (3.0 * countNonZero(inside));
}

TEST(Gcpw_RenderView, the_natural_view_keeps_the_alignment)
{
    const Scene scene{SceneOptions()};
    const Alignment alignment = alignPair(scene.source(), scene.target());
    const PairCanvas target = renderPair(alignment, scene.source(), scene.target());
    const PairCanvas natural = renderPair(alignment, scene.source(), scene.target(), View::NATURAL);
    EXPECT_LT(differenceInOverlap(natural), 1.2 * differenceInOverlap(target) + 0.1);
    EXPECT_LT(scorePair(natural).zncc, 3);
    for (const Mat& picture : {natural.source, natural.source_corrected, natural.target, natural.target_corrected, natural.mesh})
    {
        EXPECT_EQ(picture.type(), CV_8UC3);
        EXPECT_EQ(picture.size(), natural.target_mask.size());
    }
    EXPECT_EQ(natural.source_mask.size(), natural.target_mask.size());
}

TEST(Gcpw_RenderView, between_both_views_neither_photograph_takes_the_light_of_the_other)
{
    const Scene scene{SceneOptions()};
    const Mat source = scene.source();
    Mat target;
    cvtColor(scene.target(), target, COLOR_BGR2YCrCb);
    target += Scalar(0, 12, 0); // a red lamp
    cvtColor(target, target, COLOR_YCrCb2BGR);
    const PairCanvas canvas = renderPair(alignPair(source, target), source, target, View::NATURAL);
    const auto red = [](const Mat& picture, const Mat& mask)
    {
        const Scalar mean = cv::mean(picture, mask);
        return mean[2] - mean[1];
    };
    const double source_change = red(canvas.source_corrected, canvas.source_mask) - red(canvas.source, canvas.source_mask);
    const double target_change = red(canvas.target_corrected, canvas.target_mask) - red(canvas.target, canvas.target_mask);
    EXPECT_GT(source_change, 1);
    EXPECT_LT(target_change, -1);
    EXPECT_NEAR(source_change, -target_change, 3);
    const PairCanvas framed = renderPair(alignPair(source, target), source, target);
    EXPECT_EQ(cv::norm(framed.target_corrected, framed.target, NORM_INF), 0);
    Params without;
    without.method = Method::MFW;
    const PairCanvas uncorrected = renderPair(alignPair(source, target, without), source, target, View::NATURAL);
    EXPECT_EQ(cv::norm(uncorrected.target_corrected, uncorrected.target, NORM_INF), 0);
    EXPECT_EQ(cv::norm(uncorrected.source_corrected, uncorrected.source, NORM_INF), 0);
}

TEST(Gcpw_RenderView, both_photographs_are_whole_on_the_canvas_and_it_is_no_larger_than_they_need)
{
    const Matx33d h = targetFromSource(PHOTO, 35);
    const Mat white(PHOTO, CV_8UC3, Scalar::all(255));
    const PairCanvas target = renderPair(alignmentBy(h), white, white);
    const PairCanvas natural = renderPair(alignmentBy(h), white, white, View::NATURAL);
    EXPECT_LT(natural.target.size().area(), 0.6 * target.target.size().area());
    EXPECT_LT(natural.target.size().area(), 1.25 * 2 * PHOTO.area()) << "a plane enlarges towards its sides";
    EXPECT_NEAR(countNonZero(natural.source_mask) + countNonZero(natural.target_mask), 2 * PHOTO.area(), 0.25 * 2 * PHOTO.area());
    // No row or column of the canvas is empty.
    Mat any;
    const Mat covered = natural.source_mask | natural.target_mask;
    for (int dim = 0; dim < 2; ++dim)
    {
        reduce(covered, any, dim, REDUCE_MAX);
        EXPECT_GE(countNonZero(any), static_cast<int>(any.total()) - 2);
    }
}

TEST(Gcpw_RenderView, the_homography_of_a_canvas_says_where_the_target_s_pixels_are)
{
    const auto ramp = [](Point2d p) { return 20 + 0.3 * p.x + 0.2 * p.y; };
    const Matx33d h = targetFromSource(PHOTO, 12);
    const Mat source = photograph(h, ramp);
    const Mat target = photograph(Matx33d::eye(), ramp);
    for (const View view : {View::TARGET, View::NATURAL})
    {
        const PairCanvas canvas = renderPair(alignmentBy(h), source, target, view);
        ASSERT_EQ(canvas.canvas_from_target.size(), Size(3, 3));
        ASSERT_EQ(canvas.canvas_from_target.type(), CV_64FC1);
        EXPECT_LE(cv::norm(onCanvas(canvas, Point2d()) - Point2d(canvas.target_origin)), 0.75);
        for (int y = 10; y < 350; y += 20)
            for (int x = 10; x < 470; x += 20)
            {
                const Point at = onCanvas(canvas, Point2d(x, y));
                ASSERT_EQ(canvas.target_mask.at<uchar>(at), 255);
                ASSERT_NEAR(canvas.target.at<Vec3b>(at)[0], ramp(Point2d(x, y)), 2);
            }
    }
    const PairCanvas still = renderPair(alignmentBy(h), source, target);
    const Point origin = still.target_origin;
    EXPECT_EQ(Matx33d(still.canvas_from_target.ptr<double>()), Matx33d(1, 0, origin.x, 0, 1, origin.y, 0, 0, 1));
}

TEST(Gcpw_RenderView, straight_lines_stay_straight_across_both_photographs)
{
    // Nine soft dark lines of the scene; each crosses both photographs.
    const auto offsetOf = [](int k) { return 40 + 35 * k; };
    const auto heightAt = [&](int k, double x) { return offsetOf(k) + 0.05 * (k - 4) * x; };
    const auto lines = [&](Point2d p)
    {
        double gray = 230;
        for (int k = 0; k < 9; ++k)
            gray -= 200 * std::exp(-0.25 * std::pow(p.y - heightAt(k, p.x), 2));
        return gray;
    };
    const Matx33d h = targetFromSource(PHOTO, -12); // the source lies to the right
    const PairCanvas canvas =
        renderPair(alignmentBy(h), photograph(h, lines), photograph(Matx33d::eye(), lines), View::NATURAL);
    const Mat picture = blendPair(canvas, Blend::AVERAGE);
    const Mat covered = canvas.source_mask | canvas.target_mask;
    for (int k = 2; k < 7; ++k)
    {
        const Point2d a = onCanvas(canvas, Point2d(20, heightAt(k, 20)));
        const Point2d b = onCanvas(canvas, Point2d(560, heightAt(k, 560)));
        double worst = 0;
        int columns = 0;
        for (int x = cvCeil(a.x); x <= b.x; ++x)
        {
            // Centre of the darkness near the straight line between both ends.
            const double expected = a.y + (b.y - a.y) * (x - a.x) / (b.x - a.x);
            double weight = 0;
            double sum = 0;
            bool whole = true;
            for (int y = cvRound(expected) - 6; y <= cvRound(expected) + 6; ++y)
            {
                whole = whole && Rect(Point(), picture.size()).contains(Point(x, y)) && covered.at<uchar>(y, x);
                if (!whole)
                    break;
                const double dark = std::max(220.0 - picture.at<Vec3b>(y, x)[0], 0.0);
                weight += dark;
                sum += dark * y;
            }
            if (!whole)
                continue;
            ASSERT_GT(weight, 50) << k << " " << x;
            worst = std::max(worst, std::abs(sum / weight - expected));
            ++columns;
        }
        EXPECT_GT(columns, 400) << k;
        EXPECT_LT(worst, 0.5) << k;
    }
}

TEST(Gcpw_RenderView, on_a_sphere_both_photographs_meet_and_the_homography_is_right_in_the_target_s_middle)
{
    const auto waves = [](Point2d p) { return 120 + 60 * std::sin(0.1 * p.x) + 40 * std::cos(0.13 * p.y); };
    const Matx33d h = targetFromSource(PHOTO, 35);
    const PairCanvas canvas =
        renderPair(alignmentBy(h), photograph(h, waves), photograph(Matx33d::eye(), waves), View::NATURAL);
    EXPECT_LT(differenceInOverlap(canvas), 1.5);
    for (int y = 160; y < 200; y += 10)
        for (int x = 220; x < 260; x += 10)
        {
            const Point at = onCanvas(canvas, Point2d(x, y));
            ASSERT_EQ(canvas.target_mask.at<uchar>(at), 255);
            EXPECT_NEAR(canvas.target.at<Vec3b>(at)[0], waves(Point2d(x, y)), 7);
        }
    EXPECT_EQ(canvas.target_mask.at<uchar>(canvas.target_origin + Point(3, 3)), 255);
    EXPECT_EQ(canvas.target_mask.at<uchar>(canvas.target_origin + Point(-3, 3)), 0);
}

TEST(Gcpw_RenderView, pixels_that_the_target_hides_stay_hidden)
{
    const Matx33d h = targetFromSource(PHOTO, 20);
    Mat target(PHOTO, CV_8UC4, Scalar::all(200));
    const Rect hole(300, 100, 60, 40);
    target(hole).setTo(Scalar(200, 200, 200, 0));
    const PairCanvas canvas = renderPair(alignmentBy(h), Mat(PHOTO, CV_8UC3, Scalar::all(90)), target, View::NATURAL);
    for (int y = 100; y < 140; y += 8)
        for (int x = 300; x < 360; x += 8)
        {
            const Point at = onCanvas(canvas, Point2d(x + 2, y + 2));
            EXPECT_EQ(canvas.target_mask.at<uchar>(at), 0);
            EXPECT_EQ(canvas.target.at<Vec3b>(at), Vec3b());
        }
    EXPECT_EQ(canvas.target_mask.at<uchar>(Point(onCanvas(canvas, Point2d(250, 120)))), 255);
}

TEST(Gcpw_RenderView, in_the_target_s_frame_the_colors_of_the_alignment_are_shown_where_they_belong)
{
    Alignment alignment = alignmentBy(targetFromSource(PHOTO, 25));
    AlignedImage source = alignment.image(0);
    for (int row = 0; row < 32; ++row)
        for (int col = 16; col < 32; ++col)
            source.color.ptr<float>(row)[6 * col] = 0.5F; // the right half half as bright
    alignment = Alignment({source, alignment.image(1)}, Size2d(1, 1), Report());
    const Mat gray(PHOTO, CV_8UC3, Scalar::all(100));
    const PairCanvas canvas = renderPair(alignment, gray, gray, View::TARGET);
    const Matx33d from_source = Matx33d(canvas.canvas_from_target.ptr<double>()) * targetFromSource(PHOTO, 25);
    EXPECT_NEAR(canvas.source_corrected.at<Vec3b>(Point(applyHomography(from_source, Point2d(200, 180))))[0], 100, 2);
    EXPECT_NEAR(canvas.source_corrected.at<Vec3b>(Point(applyHomography(from_source, Point2d(280, 180))))[0], 50, 2);
}

TEST(Gcpw_RenderView, one_thread_and_many_give_the_same_pictures)
{
    const Scene scene{smallScene()};
    const Alignment alignment = alignPair(scene.source(), scene.target());
    const int threads = getNumThreads();
    setNumThreads(2);
    const PairCanvas many = renderPair(alignment, scene.source(), scene.target(), View::NATURAL);
    setNumThreads(1);
    const PairCanvas one = renderPair(alignment, scene.source(), scene.target(), View::NATURAL);
    setNumThreads(threads);
    ASSERT_EQ(one.target.size(), many.target.size());
    EXPECT_EQ(cv::norm(one.canvas_from_target, many.canvas_from_target, NORM_INF), 0);
    EXPECT_EQ(cv::norm(one.source_corrected, many.source_corrected, NORM_INF), 0);
    EXPECT_EQ(cv::norm(one.target, many.target, NORM_INF), 0);
}

TEST(Gcpw_RenderView, a_view_that_does_not_exist_is_refused_before_any_work)
{
    const Mat flat(100, 100, CV_8UC3, Scalar::all(9)); // cannot be aligned: work would end without a word
    Mat panorama;
    const View unknown = static_cast<View>(2);
    expectRefused([&] { stitchPair(flat, flat, panorama, Params(), Blend::AVERAGE, unknown); }, "view is 2");
    const Mat white(PHOTO, CV_8UC3, Scalar::all(255));
    expectRefused([&] { renderPair(alignmentBy(Matx33d::eye()), white, white, unknown); }, "view is 2");
}

Alignment withVertexAt(double far, int axis)
{
    const Alignment sound = alignmentBy(targetFromSource(PHOTO, 20));
    AlignedImage source = sound.image(0);
    source.mesh.at<Vec2d>(5, 7)[axis] = far;
    return {{source, sound.image(1)}, sound.canvasScale(), sound.report()};
}

TEST(Gcpw_RenderView, a_mesh_that_ran_away_makes_no_canvas_or_one_on_the_sphere)
{
    const Mat white(PHOTO, CV_8UC3, Scalar::all(255));
    for (const double far : {3e9, -3e9, 1e300, -1e300})
        for (int axis = 0; axis < 2; ++axis)
        {
            expectRefused([&] { renderPair(withVertexAt(far, axis), white, white); }, "the canvas would be");
            try
            {
                const Size size = renderPair(withVertexAt(far, axis), white, white, View::NATURAL).target.size();
                EXPECT_LT(size.area(), 20 * PHOTO.area());
            }
            catch (const cv::Exception& e)
            {
                EXPECT_NE(e.err.find("the canvas would be"), std::string::npos);
            }
        }
}

TEST(Gcpw_RenderView, one_vertex_far_out_does_not_shrink_the_photographs)
{
    const Mat white(PHOTO, CV_8UC3, Scalar::all(255));
    const PairCanvas canvas = renderPair(withVertexAt(1e5, 0), white, white, View::NATURAL);
    EXPECT_GT(countNonZero(canvas.target_mask), PHOTO.area() / 2);
}

}} // namespace
