// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#include <gtest/gtest.h>
#include <opencv2/imgproc.hpp>
#include "common/tiled_blender.hpp"
#include "fed.hpp"
#include "scratch_folder.hpp"
#include "stitch/canvas_picture.hpp"

namespace
{

/// Noise of 8 or 13 bits, with detail of all sizes.
cv::Mat noise(cv::Size size, int seed, bool deep)
{
    cv::RNG rng(static_cast<uint64_t>(seed));
    cv::Mat sum(size, CV_32FC3, cv::Scalar::all(0));
    for (const int side : {1, 16, 200})
    {
        cv::Mat part(size.height / side + 2, size.width / side + 2, CV_32FC3);
        rng.fill(part, cv::RNG::UNIFORM, 0, deep ? 2700 : 85);
        cv::resize(part, part, size, 0, 0, cv::INTER_LINEAR);
        sum += part;
    }
    cv::Mat result;
    sum.convertTo(result, deep ? CV_16S : CV_8U);
    return result;
}

/// Three pictures that overlap on a canvas whose sides are no multiples of anything.
std::vector<Fed> threePictures(bool deep)
{
    std::vector<Fed> fed;
    for (int k = 0; k < 3; ++k)
    {
        Fed one;
        one.image = noise(cv::Size(1003, 1207 - 90 * k), k + 1, deep);
        one.mask = cv::Mat(one.image.size(), CV_8UC1, cv::Scalar(0));
        cv::ellipse(one.mask, cv::Point(500, 550), cv::Size(480, 500 - 40 * k), 10.0 * k, 0, 360, cv::Scalar(255),
                    cv::FILLED);
        one.corner = cv::Point(-303 + 601 * k, 71 * k - 45);
        fed.push_back(one);
    }
    return fed;
}

Blending blendingOf(Blending::Kind kind)
{
    Blending blending;
    blending.kind = kind;
    blending.bands = 5;
    blending.sharpness = 0.02F;
    return blending;
}

/// What a blender of the whole canvas makes.
cv::Mat whole(const std::vector<Fed>& fed, const Blending& blending, bool deep)
{
    const cv::Ptr<cv::detail::Blender> blender = blenderOf(blending);
    blender->prepare(canvasOf(fed));
    for (const Fed& one : fed)
    {
        cv::Mat image;
        one.image.convertTo(image, CV_16S);
        blender->feed(image, one.mask, one.corner);
    }
    cv::Mat blended;
    cv::Mat mask;
    blender->blend(blended, mask);
    cv::Mat result;
    if (deep)
        blended.convertTo(result, CV_16U, 8);
    else
        blended.convertTo(result, CV_8U);
    return result;
}

/// The picture put together of rectangles of this size.
cv::Mat ofTiles(const CanvasPicture& picture, cv::Size tile, int type)
{
    cv::Mat result(picture.size(), type, cv::Scalar::all(7));
    for (int y = 0; y < result.rows; y += tile.height)
        for (int x = 0; x < result.cols; x += tile.width)
        {
            const cv::Rect rect = cv::Rect(x, y, tile.width, tile.height) & cv::Rect(cv::Point(), result.size());
            cv::Mat place = result(rect);
            picture.pixels(rect).copyTo(place);
        }
    return result;
}

class CanvasPictures : public testing::TestWithParam<std::tuple<Blending::Kind, bool>>
{
protected:
    void fill(const std::vector<Fed>& fed, const Blending& blending)
    {
        for (const Fed& one : fed)
            store_.add(one.image, one.mask, one.corner, CanvasPicture::marginOf(blending));
    }

    ScratchFolder folder_;
    WarpedStore store_{folder_.path()};
};

TEST_P(CanvasPictures, have_the_bits_of_one_piece_however_they_are_cut)
{
    const Blending blending = blendingOf(std::get<0>(GetParam()));
    const bool deep = std::get<1>(GetParam());
    const std::vector<Fed> fed = threePictures(deep);
    fill(fed, blending);
    const CanvasPicture picture(store_, canvasOf(fed), blending, deep, 0);
    const cv::Mat expected = whole(fed, blending, deep);
    for (const cv::Size tile : {cv::Size(512, 512), cv::Size(333, 101), cv::Size(3000, 64)})
    {
        const cv::Mat found = ofTiles(picture, tile, expected.type());
        ASSERT_EQ(found.size(), expected.size());
        EXPECT_EQ(cv::norm(found, expected, cv::NORM_INF), 0) << tile;
    }
}

INSTANTIATE_TEST_SUITE_P(blenders, CanvasPictures,
                         testing::Combine(testing::Values(Blending::NONE, Blending::FEATHER, Blending::BANDS),
                                          testing::Bool()));

class CanvasPicture8 : public CanvasPictures
{
};

TEST_P(CanvasPicture8, turned_is_the_whole_turned)
{
    const Blending blending = blendingOf(Blending::BANDS);
    const std::vector<Fed> fed = threePictures(false);
    fill(fed, blending);
    const cv::Mat expected = whole(fed, blending, false);
    for (const int turns : {1, 2})
    {
        cv::Mat turned;
        cv::rotate(expected, turned, turns == 1 ? cv::ROTATE_90_CLOCKWISE : cv::ROTATE_180);
        const CanvasPicture picture(store_, canvasOf(fed), blending, false, turns);
        const cv::Mat found = ofTiles(picture, cv::Size(400, 300), CV_8UC3);
        ASSERT_EQ(found.size(), turned.size());
        EXPECT_EQ(cv::norm(found, turned, cv::NORM_INF), 0) << turns;
    }
}

TEST_P(CanvasPicture8, shows_where_a_photograph_does_and_finds_the_largest_rectangle_of_it)
{
    const Blending blending = blendingOf(Blending::BANDS);
    const std::vector<Fed> fed = threePictures(false);
    fill(fed, blending);
    const cv::Rect canvas = canvasOf(fed);
    cv::Mat expected(canvas.size(), CV_8UC1, cv::Scalar(0));
    for (const Fed& one : fed)
    {
        cv::Mat place = expected(cv::Rect(one.corner, one.image.size()) - canvas.tl());
        cv::bitwise_or(place, one.mask, place);
    }
    const CanvasPicture picture(store_, canvas, blending, false, 0);
    EXPECT_EQ(cv::norm(picture.shown(cv::Rect(cv::Point(), canvas.size())), expected, cv::NORM_INF), 0);
    const cv::Rect inner = picture.largestRectangle();
    EXPECT_GT(inner.area(), canvas.area() / 3);
    EXPECT_EQ(cv::countNonZero(expected(inner)), inner.area());
}

INSTANTIATE_TEST_SUITE_P(bands, CanvasPicture8, testing::Values(std::make_tuple(Blending::BANDS, false)));

TEST(CanvasPicture, refuses_bands_that_reach_across_many_tiles)
{
    const ScratchFolder folder;
    const WarpedStore store(folder.path());
    Blending blending = blendingOf(Blending::BANDS);
    blending.bands = 9;
    EXPECT_THROW(CanvasPicture(store, cv::Rect(0, 0, 100, 100), blending, false, 0), std::runtime_error);
}

} // namespace
