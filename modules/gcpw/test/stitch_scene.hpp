// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#ifndef OPENCV_GCPW_TEST_STITCH_SCENE_HPP
#define OPENCV_GCPW_TEST_STITCH_SCENE_HPP

#include "rig_scene.hpp"

#include <map>
#include <vector>

namespace opencv_test
{

/// Three views with parallax; `frame` changes what is seen, not the cameras.
inline std::vector<Mat> frameOf(int frame = 0)
{
    static std::map<int, std::vector<Mat>> made;
    std::vector<Mat>& images = made[frame];
    const double yaw[] = {-0.45, 0, 0.45};
    for (int i = 0; images.size() < 3; ++i)
        images.push_back(photographOf(cameraAt(yaw[i], 0.03 * (i - 1)), 4, 1.5 * i, 7 + static_cast<uint64_t>(frame)));
    return images;
}

/// Few quads and few steps: for tests of the plumbing.
inline gcpw::Params quick()
{
    gcpw::Params params;
    params.meshCols = params.meshRows = 12;
    params.maxIterations = 3;
    return params;
}

/// Repeatable: no part of it draws at random.
inline Ptr<Stitcher> makeStitcher(Stitcher::Mode mode = Stitcher::PANORAMA)
{
    const Ptr<Stitcher> stitcher = Stitcher::create(mode);
    stitcher->setFeaturesFinder(SIFT::create(2000, 3, 0.01));
    // OpenCV takes two images for the same one if nearly all matches agree (confidence above 3, these reach 2.5 to 3.03 with its
    // default of 0.3, varying with build and random state): a laxer ratio of neighbours brings some wrong ones, and 2.0 to 2.6.
    if (mode == Stitcher::PANORAMA)
        stitcher->setFeaturesMatcher(makePtr<cv::detail::BestOf2NearestMatcher>(false, 0.15F));
    stitcher->setSeamFinder(makePtr<cv::detail::DpSeamFinder>());
    stitcher->setBlender(cv::detail::Blender::createDefault(cv::detail::Blender::MULTI_BAND));
    return stitcher;
}

inline void expectSame(const Mat& a, const Mat& b)
{
    ASSERT_EQ(a.size(), b.size());
    ASSERT_GT(countNonZero(a.reshape(1)), RIG_IMAGE.area()); // an empty picture proves nothing
    EXPECT_EQ(cv::norm(a, b, NORM_INF), 0);
}

} // namespace opencv_test

#endif
