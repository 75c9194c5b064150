// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#include "perf_precomp.hpp"

#include <opencv2/imgproc.hpp>
#include "rig_scene.hpp"
#include "thread_count.hpp"

namespace opencv_test { namespace {

/// Frames of two cameras, 1.9 Mpx each, and what composes them.
struct Frames
{
    std::vector<Mat> frames;
    gcpw::FrameComposer composer;

    static const Frames& get()
    {
        static const Frames scene = make();
        return scene;
    }

    static Frames make()
    {
        const std::vector<cv::detail::CameraParams> cameras = {cameraAt(-0.3), cameraAt(0.3)};
        gcpw::Rig rig = bentRig(makePtr<cv::SphericalWarper>(), cameras, 3);
        rig.image_sizes = {RIG_IMAGE, RIG_IMAGE};
        std::vector<Mat> frames;
        for (const cv::detail::CameraParams& camera : cameras)
        {
            Mat frame;
            resize(photographOf(camera, 0, 0), frame, RIG_IMAGE * 4, 0, 0, INTER_CUBIC);
            frames.push_back(frame);
        }
        return {frames, gcpw::FrameComposer(rig, makePtr<cv::SphericalWarper>(), frames)};
    }
};

typedef perf::TestBaseWithParam<int> Gcpw_Frames;

PERF_TEST_P(Gcpw_Frames, compose, testing::Values(1, 2))
{
    const Frames& scene = Frames::get();
    const ThreadCount threads(GetParam());
    Mat panorama;
    TEST_CYCLE() scene.composer.compose(scene.frames, panorama);
    CV_Assert(countNonZero(panorama.reshape(1)) > 0);
    SANITY_CHECK_NOTHING();
}

/// The least that a panorama can cost: as many pixels out of one frame, with a ready map.
PERF_TEST(Gcpw_Remap, as_many_pixels_as_a_frame)
{
    const Frames& scene = Frames::get();
    const ThreadCount threads(1);
    const Size size = scene.composer.size();
    Mat map(size, CV_32FC2);
    for (int y = 0; y < size.height; ++y)
        for (int x = 0; x < size.width; ++x)
            map.at<Vec2f>(y, x) = Vec2f(0.6F * static_cast<float>(x) + 0.3F, static_cast<float>(y) + 0.3F);
    Mat xy;
    Mat between;
    convertMaps(map, noArray(), xy, between, CV_16SC2);
    Mat panorama;
    TEST_CYCLE() remap(scene.frames[0], panorama, xy, between, INTER_LINEAR, BORDER_REFLECT);
    CV_Assert(panorama.size() == size);
    SANITY_CHECK_NOTHING();
}

}} // namespace
