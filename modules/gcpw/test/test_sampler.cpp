// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#include "test_precomp.hpp"

#include "imaging/sampler.hpp"
#include "seeded.hpp"

namespace opencv_test { namespace {

using namespace cv::gcpw;

/// A level whose channels are given by a function of the pixel; inside everywhere.
template <typename Value>
PyramidLevel levelOf(Size size, double scale, Value value)
{
    PyramidLevel level;
    level.scale = scale;
    level.pixels.create(size, CV_32FC4);
    for (int y = 0; y < size.height; ++y)
        for (int x = 0; x < size.width; ++x)
            for (int c = 0; c < 4; ++c)
                level.pixels.at<Vec4f>(y, x)[c] = c == 3 ? 1.0F : static_cast<float>(value(x, y, c));
    return level;
}

TEST(Gcpw_Sampler, a_ramp_is_read_exactly_with_its_slope)
{
    const PyramidLevel level =
        levelOf(Size(40, 30), 1, [](double x, double y, int c) { return 0.1 + 0.01 * (c + 1) * x - 0.003 * y; });
    RNG rng = seeded(1);
    for (int i = 0; i < 300; ++i)
    {
        const Point2d p(rng.uniform(1.0, 37.9), rng.uniform(1.0, 27.9));
        PixelSample sample;
        ASSERT_TRUE(samplePixel(level, p, sample));
        for (int c = 0; c < 3; ++c)
        {
            EXPECT_NEAR(sample.value[c], 0.1 + 0.01 * (c + 1) * p.x - 0.003 * p.y, 2e-6);
            EXPECT_NEAR(sample.dx[c], 0.01 * (c + 1), 1e-6);
            EXPECT_NEAR(sample.dy[c], -0.003, 1e-6);
        }
    }
}

TEST(Gcpw_Sampler, positions_and_slopes_are_those_of_the_reference_image_on_every_level)
{
    const PyramidLevel level = levelOf(Size(40, 30), 4, [](double x, double y, int) { return 0.02 * x + 0.01 * y; });
    PixelSample sample;
    ASSERT_TRUE(samplePixel(level, Point2d(50, 42), sample));
    EXPECT_NEAR(sample.value[0], 0.02 * 12.5 + 0.01 * 10.5, 1e-6);
    EXPECT_NEAR(sample.dx[0], 0.02 / 4, 1e-7);
    EXPECT_NEAR(sample.dy[0], 0.01 / 4, 1e-7);
}

TEST(Gcpw_Sampler, the_gradient_follows_finite_differences_of_a_smooth_picture)
{
    const PyramidLevel level = levelOf(
        Size(60, 60), 1, [](double x, double y, int c) { return 0.5 + 0.2 * std::sin(x / 8 + c) * std::cos(y / 9); });
    RNG rng = seeded(2);
    for (int i = 0; i < 300; ++i)
    {
        const Point2d p(rng.uniform(3.0, 55.0), rng.uniform(3.0, 55.0));
        PixelSample sample;
        PixelSample right;
        PixelSample left;
        ASSERT_TRUE(samplePixel(level, p, sample));
        ASSERT_TRUE(samplePixel(level, p + Point2d(1, 0), right));
        ASSERT_TRUE(samplePixel(level, p - Point2d(1, 0), left));
        // The gradient is the central difference over the two neighbouring pixels, mixed bilinearly: exactly this.
        for (int c = 0; c < 3; ++c)
        {
            EXPECT_NEAR(sample.dx[c], 0.5 * (right.value[c] - left.value[c]), 1e-6);
            EXPECT_NEAR(sample.dx[c], 0.2 / 8 * std::cos(p.x / 8 + c) * std::cos(p.y / 9), 3e-4);
            EXPECT_NEAR(sample.dy[c], -0.2 / 9 * std::sin(p.x / 8 + c) * std::sin(p.y / 9), 3e-4);
        }
    }
}

TEST(Gcpw_Sampler, positions_are_not_rounded)
{
    const PyramidLevel level = levelOf(Size(20, 20), 1, [](double x, double, int) { return x; });
    PixelSample sample;
    ASSERT_TRUE(samplePixel(level, Point2d(7.001, 5), sample));
    EXPECT_NEAR(sample.value[0], 7.001, 1e-5);
}

TEST(Gcpw_Sampler, positions_without_a_whole_neighbourhood_are_refused)
{
    const PyramidLevel level = levelOf(Size(20, 10), 1, [](double, double, int) { return 0.5; });
    const double nan = std::numeric_limits<double>::quiet_NaN();
    PixelSample sample;
    for (const Point2d& p : {Point2d(0.99, 5), Point2d(5, 0.99), Point2d(18, 5), Point2d(5, 8), Point2d(-100, 5),
                             Point2d(1e30, 5), Point2d(5, -1e30), Point2d(nan, 5), Point2d(5, nan)})
        EXPECT_FALSE(samplePixel(level, p, sample)) << p;
    for (const Point2d& p : {Point2d(1, 1), Point2d(17.99, 7.99)})
        EXPECT_TRUE(samplePixel(level, p, sample)) << p;
}

TEST(Gcpw_Sampler, a_position_beside_the_mask_is_refused)
{
    PyramidLevel level = levelOf(Size(20, 20), 1, [](double, double, int) { return 0.5; });
    level.pixels.at<Vec4f>(10, 10)[3] = 0;
    PixelSample sample;
    EXPECT_FALSE(samplePixel(level, Point2d(10, 10), sample));
    EXPECT_FALSE(samplePixel(level, Point2d(9.5, 9.5), sample));
    EXPECT_FALSE(samplePixel(level, Point2d(10.8, 9.2), sample));
    EXPECT_TRUE(samplePixel(level, Point2d(12, 10), sample));
    EXPECT_TRUE(samplePixel(level, Point2d(10, 7.9), sample));
}

}} // namespace
