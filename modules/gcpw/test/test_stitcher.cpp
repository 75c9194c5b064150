// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#include "test_precomp.hpp"

#include <algorithm>
#include <cstdio>
#include <thread>
#include "stitch_scene.hpp"

namespace opencv_test { namespace {

TEST(Gcpw_Stitcher, stitch_refines_the_alignment)
{
    const Ptr<Stitcher> stitcher = makeStitcher();
    const Ptr<gcpw::StitcherBinding> binding = gcpw::attach(stitcher, quick());
    Mat panorama;
    ASSERT_EQ(stitcher->stitch(frameOf(), panorama), Stitcher::OK);
    EXPECT_TRUE(binding->rig().usable()) << binding->rig().alignment.report().message;
    EXPECT_EQ(binding->estimations(), 1);
    EXPECT_EQ(binding->rig().alignment.report().folds, 0);
    ASSERT_GE(binding->rig().alignment.report().pairs.size(), size_t(2));
    for (const gcpw::PairReport& pair : binding->rig().alignment.report().pairs)
    {
        if (pair.points > 50)
        {
            EXPECT_LT(pair.miss_after, 0.7 * pair.miss_before);
        }
    }
}

TEST(Gcpw_Stitcher, one_estimate_serves_many_frames_and_setTransform_gives_the_same_bits)
{
    const Ptr<Stitcher> stitcher = makeStitcher();
    const Ptr<gcpw::StitcherBinding> binding = gcpw::attach(stitcher, quick());
    Mat first;
    ASSERT_EQ(stitcher->estimateTransform(frameOf()), Stitcher::OK);
    ASSERT_EQ(stitcher->composePanorama(first), Stitcher::OK);
    Mat again;
    ASSERT_EQ(stitcher->setTransform(frameOf(), stitcher->cameras(), stitcher->component()), Stitcher::OK);
    ASSERT_EQ(stitcher->composePanorama(again), Stitcher::OK);
    expectSame(first, again);
    Mat other;
    ASSERT_EQ(stitcher->composePanorama(frameOf(1), other), Stitcher::OK);
    EXPECT_EQ(other.size(), first.size());
    ASSERT_GT(cv::norm(frameOf()[0], frameOf(1)[0], NORM_INF), 0);
    EXPECT_GT(cv::norm(first, other, NORM_INF), 0);
    EXPECT_EQ(binding->estimations(), 1);
}

TEST(Gcpw_Stitcher, a_loaded_rig_gives_the_same_bits)
{
    const Ptr<Stitcher> stitcher = makeStitcher();
    const Ptr<gcpw::StitcherBinding> binding = gcpw::attach(stitcher, quick());
    Mat first;
    ASSERT_EQ(stitcher->stitch(frameOf(), first), Stitcher::OK);
    const std::string path = cv::tempfile(".json.gz");
    binding->rig().save(path);
    const gcpw::Rig rig = gcpw::Rig::load(path);
    std::remove(path.c_str());

    const Ptr<Stitcher> second = makeStitcher();
    const Ptr<gcpw::StitcherBinding> second_binding = gcpw::attach(second, quick());
    second_binding->setRig(rig);
    Mat again;
    ASSERT_EQ(second->setTransform(frameOf(), rig.cameras, rig.component), Stitcher::OK);
    ASSERT_EQ(second->composePanorama(again), Stitcher::OK);
    EXPECT_EQ(second_binding->estimations(), 0);
    expectSame(first, again);
}

TEST(Gcpw_Stitcher, setTransform_gives_the_same_bits_where_an_image_was_dropped_and_sizes_differ)
{
    std::vector<Mat> images = frameOf();
    resize(images[2], images[2], Size(), 1.25, 1.25, INTER_CUBIC);
    images.insert(images.begin(), Mat(RIG_IMAGE, CV_8UC3, Scalar::all(128)));
    const Ptr<Stitcher> stitcher = makeStitcher();
    const Ptr<gcpw::StitcherBinding> binding = gcpw::attach(stitcher, quick());
    Mat first;
    ASSERT_EQ(stitcher->estimateTransform(images), Stitcher::OK);
    ASSERT_EQ(stitcher->composePanorama(first), Stitcher::OK);
    ASSERT_EQ(stitcher->component(), (std::vector<int>{1, 2, 3}));
    ASSERT_TRUE(binding->rig().usable());
    Mat again;
    ASSERT_EQ(stitcher->setTransform(images, stitcher->cameras(), stitcher->component()), Stitcher::OK);
    ASSERT_EQ(stitcher->composePanorama(again), Stitcher::OK);
    expectSame(first, again);
    EXPECT_EQ(binding->estimations(), 1);
}

/// RMS difference, gray levels, of neighbouring images where both are warped to.
double ghosts(cv::detail::RotationWarper& warper, const std::vector<cv::detail::CameraParams>& cameras, const std::vector<Mat>& images)
{
    std::vector<Mat> warped(images.size());
    std::vector<Mat> masks(images.size());
    std::vector<Point> corners;
    for (size_t i = 0; i < images.size(); ++i)
    {
        const Mat K = intrinsics(cameras[i]);
        corners.push_back(warper.warp(images[i], K, cameras[i].R, INTER_LINEAR, BORDER_REFLECT, warped[i]));
        warper.warp(Mat(images[i].size(), CV_8UC1, Scalar(255)), K, cameras[i].R, INTER_NEAREST, BORDER_CONSTANT, masks[i]);
    }
    double sum = 0;
    int count = 0;
    for (size_t i = 0; i + 1 < images.size(); ++i)
    {
        const Rect shared = Rect(corners[i], warped[i].size()) & Rect(corners[i + 1], warped[i + 1].size());
        const Mat both = masks[i](shared - corners[i]) & masks[i + 1](shared - corners[i + 1]);
        const double difference = cv::norm(warped[i](shared - corners[i]), warped[i + 1](shared - corners[i + 1]), NORM_L2, both);
        sum += difference * difference;
        count += 3 * countNonZero(both);
    }
    EXPECT_GT(count, 30000);
    return std::sqrt(sum / count);
}

TEST(Gcpw_Stitcher, a_saved_model_of_one_frame_serves_the_next_without_estimating)
{
    const Ptr<Stitcher> first = makeStitcher();
    gcpw::Params params = quick();
    params.maxIterations = 8;
    const Ptr<gcpw::StitcherBinding> first_binding = gcpw::attach(first, params);
    ASSERT_EQ(first->estimateTransform(frameOf()), Stitcher::OK);
    Mat expected;
    ASSERT_EQ(first->composePanorama(frameOf(1), expected), Stitcher::OK);
    const std::string path = cv::tempfile(".yml.gz");
    first_binding->rig().save(path);
    const gcpw::Rig rig = gcpw::Rig::load(path);
    std::remove(path.c_str());

    const Ptr<Stitcher> second = makeStitcher();
    const Ptr<gcpw::StitcherBinding> binding = gcpw::attach(second, quick(), [](const std::string& stage, double)
    {
        ADD_FAILURE() << "estimated: " << stage;
        return true;
    });
    binding->setRig(rig);
    Mat panorama;
    ASSERT_EQ(second->setTransform(frameOf(1), rig.cameras, rig.component), Stitcher::OK);
    ASSERT_EQ(second->composePanorama(panorama), Stitcher::OK);
    EXPECT_EQ(binding->estimations(), 0);
    EXPECT_TRUE(binding->rig().usable());
    expectSame(expected, panorama);
    const Ptr<WarperCreator> base = makePtr<cv::SphericalWarper>();
    const double before = ghosts(*base->create(rig.scale), rig.cameras, frameOf(1));
    const double after = ghosts(*gcpw::GcpwWarper(base, rig).create(rig.scale), rig.cameras, frameOf(1));
    EXPECT_LT(after, 0.5 * before) << "the next frame has other things at the same depths";
}

TEST(Gcpw_Stitcher, two_threads_at_once_give_the_bits_of_one_after_another)
{
    const std::vector<cv::detail::CameraParams> cameras{cameraAt(-0.45, -0.03), cameraAt(0), cameraAt(0.45, 0.03)};
    const std::vector<Mat> frames[] = {frameOf(0), frameOf(1)};
    Mat alone[2];
    Mat together[2];
    const auto stitch = [&](int frame, Mat& panorama)
    {
        const Ptr<Stitcher> stitcher = makeStitcher();
        const Ptr<gcpw::StitcherBinding> binding = gcpw::attach(stitcher, quick());
        binding->setImages(frames[frame]);
        if (stitcher->setTransform(frames[frame], cameras) != Stitcher::OK || stitcher->composePanorama(panorama) != Stitcher::OK ||
            !binding->rig().usable())
            panorama.release();
    };
    for (int i = 0; i < 2; ++i)
        stitch(i, alone[i]);
    std::thread other([&] { stitch(1, together[1]); });
    stitch(0, together[0]);
    other.join();
    for (int i = 0; i < 2; ++i)
        expectSame(alone[i], together[i]);
    EXPECT_GT(cv::norm(frames[0][1], frames[1][1], NORM_INF), 0);
}

TEST(Gcpw_Stitcher, setTransform_with_unknown_cameras_estimates_only_from_images_it_was_given)
{
    const std::vector<cv::detail::CameraParams> cameras{cameraAt(-0.45, -0.03), cameraAt(0), cameraAt(0.45, 0.03)};
    const Ptr<Stitcher> plain = makeStitcher();
    Mat expected;
    ASSERT_EQ(plain->setTransform(frameOf(), cameras), Stitcher::OK);
    ASSERT_EQ(plain->composePanorama(expected), Stitcher::OK);

    const Ptr<Stitcher> stitcher = makeStitcher();
    const Ptr<gcpw::StitcherBinding> binding = gcpw::attach(stitcher, quick());
    Mat panorama;
    ASSERT_EQ(stitcher->setTransform(frameOf(), cameras), Stitcher::OK);
    ASSERT_EQ(stitcher->composePanorama(panorama), Stitcher::OK);
    expectSame(expected, panorama);
    EXPECT_FALSE(binding->rig().alignment.report().message.empty());

    binding->setImages(frameOf());
    ASSERT_EQ(stitcher->setTransform(frameOf(), cameras), Stitcher::OK);
    ASSERT_EQ(stitcher->composePanorama(panorama), Stitcher::OK);
    EXPECT_TRUE(binding->rig().usable());
    EXPECT_EQ(binding->estimations(), 1);
}

TEST(Gcpw_Stitcher, stitcher_and_binding_do_not_hold_each_other)
{
    Ptr<Stitcher> stitcher = makeStitcher();
    Ptr<gcpw::StitcherBinding> binding = gcpw::attach(stitcher, quick());
    const std::weak_ptr<Stitcher> stitcher_alive = stitcher;
    const std::weak_ptr<gcpw::StitcherBinding> binding_alive = binding;
    binding.reset();
    EXPECT_FALSE(binding_alive.expired()); // the stitcher works on for who ignores the return value
    stitcher.reset();
    EXPECT_TRUE(stitcher_alive.expired());
    EXPECT_TRUE(binding_alive.expired());
}

TEST(Gcpw_Stitcher, images_of_mixed_sizes_and_one_that_does_not_belong)
{
    std::vector<Mat> images = frameOf();
    resize(images[1], images[1], Size(), 1.3, 1.3, INTER_CUBIC);
    Mat stranger(RIG_IMAGE, CV_8UC3, Scalar::all(128));
    images.insert(images.begin() + 1, stranger);
    const Ptr<Stitcher> stitcher = makeStitcher();
    gcpw::Params params = quick();
    params.referenceImage = 3;
    const Ptr<gcpw::StitcherBinding> binding = gcpw::attach(stitcher, params);
    Mat panorama;
    ASSERT_EQ(stitcher->stitch(images, panorama), Stitcher::OK);
    EXPECT_EQ(stitcher->component(), (std::vector<int>{0, 2, 3}));
    ASSERT_TRUE(binding->rig().usable()) << binding->rig().alignment.report().message;
    const gcpw::Alignment::Image& fixed = binding->rig().alignment.image(2);
    EXPECT_EQ(cv::norm(fixed.mesh, fixed.rough, NORM_INF), 0);
}

TEST(Gcpw_Stitcher, scans_with_a_change_of_scale_line_up)
{
    const Texture texture(3);
    std::vector<Mat> images;
    for (const double zoom : {1.0, 1.2})
    {
        Mat image(360, 420, CV_8UC3);
        for (int y = 0; y < image.rows; ++y)
            for (int x = 0; x < image.cols; ++x)
                image.at<Vec3b>(y, x) = Vec3b(texture.at(Point2d(x / zoom + (zoom > 1 ? 170 : 0), y / zoom)) * 255.0);
        images.push_back(image);
    }
    const Ptr<Stitcher> stitcher = makeStitcher(Stitcher::SCANS);
    const Ptr<gcpw::StitcherBinding> binding = gcpw::attach(stitcher, quick());
    Mat panorama;
    ASSERT_EQ(stitcher->stitch(images, panorama), Stitcher::OK);
    // The rough alignment is nearly the truth here: it may be kept.
    const gcpw::Report& report = binding->rig().alignment.report();
    ASSERT_TRUE(report.status == gcpw::Status::OK || report.status == gcpw::Status::ROUGH) << report.message;
    EXPECT_FALSE(report.pairs.empty());
    for (const gcpw::PairReport& pair : report.pairs)
        EXPECT_LT(pair.miss_after, 10);
    // The same point of the scene, seen by either scan, lies at one place of the canvas.
    const Ptr<cv::detail::RotationWarper> warper = stitcher->warper()->create(1);
    for (const Point2d p : {Point2d(250, 60), Point2d(330, 150), Point2d(400, 280)})
    {
        const Mat K = Mat::eye(3, 3, CV_32F);
        const Point2f a = warper->warpPoint(Point2f(p), K, stitcher->cameras()[0].R);
        const Point2f b = warper->warpPoint(Point2f(Point2d((p.x - 170) * 1.2, p.y * 1.2)), K, stitcher->cameras()[1].R);
        EXPECT_LE(cv::norm(a - b), 0.5) << a << b;
    }
}

TEST(Gcpw_Stitcher, images_across_the_seam_join_the_circle)
{
    // 12 views of a sphere: every neighbour is found, also across +-180 degrees.
    std::vector<Mat> images;
    std::vector<cv::detail::CameraParams> cameras;
    for (int i = 0; i < 12; ++i)
    {
        const cv::detail::CameraParams truth = cameraAt(2 * CV_PI * i / 12 + 0.1);
        images.push_back(photographOf(truth, 0, 0));
        cameras.push_back(truth);
    }
    gcpw::Params params = quick();
    params.referenceImage = 0;
    const gcpw::Rig rig = gcpw::alignRig(images, cameras, makePtr<cv::SphericalWarper>(), params);
    // The cameras are the truth: the rough alignment may be kept.
    const gcpw::Report& report = rig.alignment.report();
    ASSERT_TRUE(report.status == gcpw::Status::OK || report.status == gcpw::Status::ROUGH) << report.message;
    EXPECT_GE(report.pairs.size(), size_t(12));
    EXPECT_GT(std::count_if(rig.turns.begin(), rig.turns.end(), [](double turn) { return turn != 0; }), 0);
}

}} // namespace
