// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#include "test_precomp.hpp"

#include <opencv2/imgproc.hpp>
#include <opencv2/stitching/detail/util.hpp>
#include "refusal.hpp"
#include "rig_scene.hpp"

namespace opencv_test
{
namespace
{

using cv::gcpw::FrameComposer;

const std::vector<cv::detail::CameraParams> CAMERAS = {cameraAt(-0.3), cameraAt(0.3)};

gcpw::Rig smallRig()
{
    gcpw::Rig rig = bentRig(makePtr<cv::SphericalWarper>(), CAMERAS, 3);
    rig.image_sizes = {RIG_IMAGE, RIG_IMAGE};
    rig.projection = "spherical";
    return rig;
}

std::vector<Mat> framesOf(uint64_t seed = 7)
{
    return {photographOf(CAMERAS[0], 0, 0, seed), photographOf(CAMERAS[1], 0, 0, seed)};
}

/// A picture of a rig's image by warper and compensator, on the canvas of all.
struct Warped
{
    Mat picture;
    Mat mask;
    Point corner;
};

std::vector<Warped> warpedBy(const gcpw::Rig& rig, const std::vector<Mat>& frames)
{
    const gcpw::GcpwWarper creator(makePtr<cv::SphericalWarper>(), rig);
    const Ptr<cv::detail::RotationWarper> warper = creator.create(rig.scale);
    const Ptr<gcpw::GcpwCompensator> compensator = creator.compensator();
    std::vector<Warped> all;
    for (size_t k = 0; k < frames.size(); ++k)
    {
        Warped one;
        const Mat K = intrinsics(CAMERAS[k]);
        const Mat inside(frames[k].size(), CV_8UC1, Scalar(255));
        one.corner = warper->warp(frames[k], K, CAMERAS[k].R, INTER_LINEAR, BORDER_REFLECT, one.picture);
        warper->warp(inside, K, CAMERAS[k].R, INTER_NEAREST, BORDER_CONSTANT, one.mask);
        compensator->apply(static_cast<int>(k), one.corner, one.picture, one.mask);
        all.push_back(one);
    }
    return all;
}

TEST(Gcpw_FrameComposer, shows_what_warper_and_compensator_show)
{
    const gcpw::Rig rig = smallRig();
    const FrameComposer composer(rig, framesOf());
    const std::vector<Mat> frames = framesOf(11); // others than those it was made with
    Mat panorama;
    composer.compose(frames, panorama);
    ASSERT_EQ(panorama.type(), CV_8UC3);
    ASSERT_EQ(panorama.size(), composer.size());
    const std::vector<Warped> warped = warpedBy(rig, frames);
    const Rect canvas = cv::detail::resultRoi(std::vector<Point>{warped[0].corner, warped[1].corner},
                                              std::vector<Size>{warped[0].picture.size(), warped[1].picture.size()});
    ASSERT_EQ(canvas.size(), panorama.size());
    Mat low(canvas.size(), CV_8UC3, Scalar::all(255));
    Mat high(canvas.size(), CV_8UC3, Scalar::all(0));
    Mat covered = Mat::zeros(canvas.size(), CV_8UC1);
    for (const Warped& one : warped)
    {
        const Rect rect(one.corner - canvas.tl(), one.picture.size());
        Mat(cv::min(low(rect), one.picture)).copyTo(low(rect), one.mask);
        Mat(cv::max(high(rect), one.picture)).copyTo(high(rect), one.mask);
        covered(rect) |= one.mask;
    }
    // Between the pictures that lie there, and black where there is none.
    const int tolerance = 3;
    int outside = 0;
    for (int y = 0; y < canvas.height; ++y)
        for (int x = 0; x < canvas.width; ++x)
            for (int c = 0; c < 3; ++c)
            {
                const int value = panorama.at<Vec3b>(y, x)[c];
                if (covered.at<uchar>(y, x) == 0)
                    outside += value != 0;
                else
                    outside +=
                        value < low.at<Vec3b>(y, x)[c] - tolerance || value > high.at<Vec3b>(y, x)[c] + tolerance;
            }
    EXPECT_LE(outside, 3 * (canvas.width + canvas.height) / 50) << "single pixels of a border, at most";
}

TEST(Gcpw_FrameComposer, shows_white_frames_without_a_gap_and_as_bright_as_they_are)
{
    gcpw::Rig rig = smallRig();
    std::vector<gcpw::Alignment::Image> images;
    for (int k = 0; k < 2; ++k)
    {
        images.push_back(rig.alignment.image(k));
        images.back().color.setTo(0);
        for (int row = 0; row < images.back().color.rows; ++row)
            for (int col = 0; col < images.back().color.cols; ++col)
                images.back().color.at<Vec<float, 6>>(row, col) = Vec<float, 6>(1, 1, 1, 0, 0, 0);
    }
    rig.alignment = gcpw::Alignment(images, Size2d(1, 1), gcpw::Report());
    const std::vector<Mat> white(2, Mat(RIG_IMAGE, CV_8UC3, Scalar::all(240)));
    Mat panorama;
    FrameComposer(rig, framesOf()).compose(white, panorama);
    Mat gray;
    cvtColor(panorama, gray, COLOR_BGR2GRAY);
    EXPECT_EQ(countNonZero((gray > 0) & (gray < 239)), 0);
    EXPECT_EQ(countNonZero(gray > 241), 0);
    EXPECT_GT(countNonZero(gray), gray.size().area() / 2);
}

TEST(Gcpw_FrameComposer, gives_the_same_bits_with_any_number_of_threads_and_at_every_call)
{
    const std::vector<Mat> frames = framesOf();
    const FrameComposer composer(smallRig(), frames);
    const int threads = cv::getNumThreads();
    Mat first;
    Mat again;
    cv::setNumThreads(1);
    composer.compose(frames, first);
    cv::setNumThreads(2);
    composer.compose(framesOf(3), again);
    EXPECT_GT(cv::norm(first, again, NORM_INF), 10);
    composer.compose(frames, again);
    cv::setNumThreads(threads);
    EXPECT_EQ(cv::norm(first, again, NORM_INF), 0);
}

TEST(Gcpw_FrameComposer, takes_frames_of_another_size_and_a_scale)
{
    std::vector<Mat> frames = framesOf();
    for (Mat& frame : frames)
        cv::resize(frame, frame, Size(), 2, 2);
    const Size one = FrameComposer(smallRig(), framesOf()).size();
    const Size two = FrameComposer(smallRig(), frames).size();
    const Size half = FrameComposer(smallRig(), makePtr<cv::SphericalWarper>(), frames, 0.5).size();
    EXPECT_NEAR(two.width, 2 * one.width, 4);
    EXPECT_NEAR(two.height, 2 * one.height, 4);
    EXPECT_NEAR(half.width, one.width, 2);
    EXPECT_NEAR(half.height, one.height, 2);
}

TEST(Gcpw_FrameComposer, refuses_what_does_not_fit_and_says_what)
{
    const std::vector<Mat> frames = framesOf();
    const FrameComposer composer(smallRig(), frames);
    Mat panorama;
    const auto compose = [&](const Mat& second) { composer.compose(std::vector<Mat>{frames[0], second}, panorama); };
    expectRefused([&] { compose(Mat(30, 40, CV_8UC3)); }, "frame 1 is 40 x 30 px");
    expectRefused([&] { compose(Mat(RIG_IMAGE, CV_8UC1)); }, "CV_8UC3");
    expectRefused([&] { composer.compose(std::vector<Mat>{frames[0]}, panorama); }, "one frame for each image");
    expectRefused([&] { FrameComposer(gcpw::Rig(), makePtr<cv::SphericalWarper>(), frames); }, "usable()");
    expectRefused([&] { FrameComposer(smallRig(), frames, 0); }, "scale is 0");
    expectRefused(
        [&] {
        FrameComposer(smallRig(), std::vector<Mat>{frames[0], Mat(RIG_IMAGE.width, RIG_IMAGE.height, CV_8UC3)});
        },
        "the shape of the rig's");
    gcpw::Rig nameless = smallRig();
    nameless.projection = "";
    expectRefused([&] { FrameComposer(nameless, frames); }, "no warper");
}

} // namespace
} // namespace opencv_test
