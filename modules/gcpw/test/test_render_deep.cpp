// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#include "test_precomp.hpp"

#include "scene.hpp"
#include "seeded.hpp"

namespace opencv_test
{
namespace
{

using namespace cv::gcpw;

/// 16 bits of a picture of 8. @param low whether the lower eight are filled with noise
Mat deepOf(const Mat& picture, bool low)
{
    Mat deep;
    picture.convertTo(deep, CV_16U, 257);
    Mat noise(picture.size(), CV_16UC3, Scalar::all(0));
    if (low)
        seeded(5).fill(noise, RNG::UNIFORM, -100, 100);
    return deep + noise;
}

/// Largest difference of a picture of 16 bits from one of 8, in levels of 8 bits.
double levelsApart(const Mat& deep, const Mat& bytes)
{
    Mat same;
    bytes.convertTo(same, CV_16U, 257);
    return cv::norm(deep, same, NORM_INF) / 257;
}

TEST(Gcpw_RenderDeep, a_canvas_of_sixteen_bits_is_that_of_eight_with_finer_levels)
{
    SceneOptions options = smallScene();
    options.recolored = true;
    const Scene scene(options);
    const Alignment alignment = alignPair(scene.source(), scene.target());
    ASSERT_TRUE(alignment.ok());
    for (const View view : {View::TARGET, View::NATURAL})
    {
        const PairCanvas bytes = renderPair(alignment, scene.source(), scene.target(), view);
        const PairCanvas deep =
            renderPair(alignment, deepOf(scene.source(), false), deepOf(scene.target(), false), view);
        EXPECT_EQ(cv::norm(deep.source_mask, bytes.source_mask, NORM_INF), 0);
        EXPECT_EQ(cv::norm(deep.target_mask, bytes.target_mask, NORM_INF), 0);
        for (const Mat& picture : {deep.source, deep.target, deep.source_corrected, deep.target_corrected})
            ASSERT_EQ(picture.type(), CV_16UC3);
        EXPECT_EQ(deep.mesh.type(), CV_8UC3);
        EXPECT_LE(levelsApart(deep.source, bytes.source), 1);
        EXPECT_LE(levelsApart(deep.target, bytes.target), 1);
        // Rounded once more before the correction, and the colours of the natural view are found anew.
        EXPECT_LE(levelsApart(deep.source_corrected, bytes.source_corrected), 3);
        EXPECT_LE(levelsApart(deep.target_corrected, bytes.target_corrected), 3);
        EXPECT_NEAR(scorePair(deep).zncc, scorePair(bytes).zncc, 0.05);
        const Mat mean = blendPair(deep, Blend::AVERAGE);
        ASSERT_EQ(mean.type(), CV_16UC3);
        EXPECT_LE(levelsApart(mean, blendPair(bytes, Blend::AVERAGE)), 2);
        const Mat picture = blendPair(deep, Blend::MULTIBAND);
        ASSERT_EQ(picture.type(), CV_16UC3);
        // OpenCV's blender rounds each band: 8 bits lose two to three levels in the mean, 16 a tenth of one.
        Mat same;
        blendPair(bytes, Blend::MULTIBAND).convertTo(same, CV_16U, 257);
        EXPECT_LT(cv::norm(picture, same, NORM_L1) / (257 * 3.0 * static_cast<double>(same.total())), 3);
    }
}

TEST(Gcpw_RenderDeep, what_lies_between_two_levels_of_eight_bits_is_kept)
{
    const Scene scene{smallScene()};
    const Mat source = deepOf(scene.source(), true);
    const Mat target = deepOf(scene.target(), true);
    const Alignment alignment = alignPair(source, target);
    const PairCanvas canvas = renderPair(alignment, source, target);
    const Rect place(canvas.target_origin, target.size());
    EXPECT_EQ(cv::norm(canvas.target(place), target, NORM_INF), 0);
    Mat alone; // and not next to what the source shows
    cv::erode(canvas.target_mask & (canvas.source_mask == 0), alone, Mat::ones(31, 31, CV_8U), Point(-1, -1), 1,
              BORDER_CONSTANT, Scalar(0));
    ASSERT_GT(countNonZero(alone), 500);
    EXPECT_EQ(cv::norm(blendPair(canvas, Blend::AVERAGE), canvas.target, NORM_INF, alone), 0);
    const double quarter = 64; // of a level of 8 bits
    EXPECT_LE(cv::norm(blendPair(canvas, Blend::MULTIBAND), canvas.target, NORM_L1, alone) /
                  (3.0 * countNonZero(alone)),
              quarter);
}

TEST(Gcpw_RenderDeep, one_photograph_of_sixteen_bits_is_enough)
{
    const Scene scene{smallScene()};
    const Alignment alignment = alignPair(scene.source(), scene.target());
    const Mat target = deepOf(scene.target(), true);
    const PairCanvas canvas = renderPair(alignment, scene.source(), target);
    EXPECT_EQ(cv::norm(canvas.target(Rect(canvas.target_origin, target.size())), target, NORM_INF), 0);
    EXPECT_LE(levelsApart(canvas.source, renderPair(alignment, scene.source(), scene.target()).source), 1);
    Mat panorama;
    ASSERT_TRUE(stitchPair(scene.source(), target, panorama));
    EXPECT_EQ(panorama.type(), CV_16UC3);
}

} // namespace
} // namespace opencv_test
