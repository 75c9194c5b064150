// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#include "perf_precomp.hpp"

#include "stitch_scene.hpp"
#include "thread_count.hpp"

namespace opencv_test { namespace {

/// Four photographs of 0.48 Mpx with parallax.
const std::vector<Mat>& photographs()
{
    static const std::vector<Mat> images = []
    {
        std::vector<Mat> made;
        for (int i = 0; i < 4; ++i)
        {
            cv::detail::CameraParams camera = cameraAt(0.45 * (i - 1.5), i % 2 == 0 ? 0.03 : -0.03);
            camera.focal *= 2;
            camera.ppx *= 2;
            camera.ppy *= 2;
            made.push_back(photographOf(camera, 3, 1.5 * i, 7, RIG_IMAGE * 2));
        }
        return made;
    }();
    return images;
}

Mat stitch(const Ptr<Stitcher>& stitcher)
{
    Mat panorama;
    cv::setRNGSeed(1); // OpenCV's matching draws at random: every round the same work
    CV_Assert(stitcher->stitch(photographs(), panorama) == Stitcher::OK);
    CV_Assert(stitcher->component().size() == photographs().size());
    return panorama;
}

Mat stitchWithGcpw(const Ptr<Stitcher>& stitcher)
{
    const Ptr<gcpw::StitcherBinding> binding = gcpw::attach(stitcher);
    const Mat panorama = stitch(stitcher);
    CV_Assert(binding->rig().usable());
    return panorama;
}

/// The stitcher as OpenCV makes it: ORB keypoints, graph-cut seams.
PERF_TEST(Gcpw_Stitcher, as_it_comes)
{
    const ThreadCount threads(1);
    photographs();
    TEST_CYCLE() stitch(Stitcher::create(Stitcher::PANORAMA));
    SANITY_CHECK_NOTHING();
}

PERF_TEST(Gcpw_Stitcher, as_it_comes_with_gcpw)
{
    const ThreadCount threads(1);
    photographs();
    TEST_CYCLE() stitchWithGcpw(Stitcher::create(Stitcher::PANORAMA));
    SANITY_CHECK_NOTHING();
}

/// SIFT keypoints, which GCPW uses again, and seams by dynamic programming.
PERF_TEST(Gcpw_Stitcher, with_sift)
{
    const ThreadCount threads(1);
    photographs();
    TEST_CYCLE() stitch(makeStitcher());
    SANITY_CHECK_NOTHING();
}

PERF_TEST(Gcpw_Stitcher, with_sift_and_gcpw)
{
    const ThreadCount threads(1);
    photographs();
    TEST_CYCLE() stitchWithGcpw(makeStitcher());
    SANITY_CHECK_NOTHING();
}

}} // namespace
