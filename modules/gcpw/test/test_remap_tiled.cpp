// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#include "test_precomp.hpp"

#include <opencv2/imgproc.hpp>
#include "rendering/remap_tiled.hpp"
#include "seeded.hpp"

namespace opencv_test { namespace {

using namespace cv::gcpw;

/// Maps that swap top and bottom and bend a little: a tile that were written early would be read again.
Mat flippedMap(Size size)
{
    Mat map(size, CV_32FC2);
    for (int y = 0; y < size.height; ++y)
        for (int x = 0; x < size.width; ++x)
            map.at<Vec2f>(y, x) = Vec2f(static_cast<float>(x + 2 * std::sin(0.1 * y)), static_cast<float>(size.height - 1 - y));
    return map;
}

Mat noise(Size size, int type)
{
    Mat image(size, type);
    RNG rng = seeded(9);
    rng.fill(image, RNG::UNIFORM, 0, 256);
    return image;
}

TEST(Gcpw_RemapTiled, tiles_give_the_picture_of_one_call_with_one_map_or_two)
{
    for (const int type : {CV_8UC1, CV_8UC3})
        for (const int interpolation : {INTER_NEAREST, INTER_LINEAR, INTER_CUBIC})
        {
            const Size size(23, 2100);
            const Mat image = noise(size, type);
            const Mat map = flippedMap(size);
            Mat expected;
            remap(image, expected, map, noArray(), interpolation, BORDER_REFLECT);
            Mat picture;
            remapTiled(image, picture, map, Mat(), interpolation, BORDER_REFLECT);
            EXPECT_EQ(cv::norm(picture, expected, NORM_INF), 0) << type << interpolation;
            Mat xy[2];
            split(map, xy);
            Mat second;
            remapTiled(image, second, xy[0], xy[1], interpolation, BORDER_REFLECT);
            EXPECT_EQ(cv::norm(second, expected, NORM_INF), 0) << type << interpolation;
        }
}

TEST(Gcpw_RemapTiled, a_picture_may_be_remapped_in_place)
{
    const Size size(23, 2100);
    Mat image = noise(size, CV_8UC3);
    const Mat map = flippedMap(size);
    Mat expected;
    remapTiled(image, expected, map, Mat(), INTER_LINEAR, BORDER_CONSTANT);
    remapTiled(image, image, map, Mat(), INTER_LINEAR, BORDER_CONSTANT);
    EXPECT_EQ(cv::norm(image, expected, NORM_INF), 0);
    // Also into another size.
    Mat small = noise(Size(40, 30), CV_8UC3);
    const Mat before = small.clone();
    remapTiled(small, small, map, Mat(), INTER_NEAREST, BORDER_REPLICATE);
    remapTiled(before, expected, map, Mat(), INTER_NEAREST, BORDER_REPLICATE);
    EXPECT_EQ(cv::norm(small, expected, NORM_INF), 0);
}

}} // namespace
