// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#include "test_precomp.hpp"

#include "overlap/color_moments.hpp"

namespace opencv_test { namespace {

using namespace cv::gcpw;

/// `count` pairs whose target is gain * source + bias, but for a share of independent noise.
ColorMoments momentsOf(int count, double gain, double bias, double noise)
{
    RNG rng(5);
    ColorMoments moments;
    for (int i = 0; i < count; ++i)
    {
        float source[3];
        float target[3];
        for (int c = 0; c < 3; ++c)
        {
            source[c] = rng.uniform(0.2F, 0.8F);
            target[c] = static_cast<float>(gain * source[c] + bias + noise * rng.uniform(-1.0, 1.0));
        }
        moments.add(source, target);
    }
    return moments;
}

TEST(Gcpw_ColorMoments, an_affine_change_shows_in_means_and_deviations)
{
    const ColorMoments m = momentsOf(500, 0.7, 0.1, 0);
    EXPECT_EQ(m.samples(), 500);
    for (int c = 0; c < 3; ++c)
    {
        EXPECT_NEAR(m.targetMean(c), 0.7 * m.sourceMean(c) + 0.1, 1e-6);
        EXPECT_NEAR(m.targetVariance(c), 0.49 * m.sourceVariance(c), 1e-6);
        EXPECT_NEAR(m.covariance(c), 0.7 * m.sourceVariance(c), 1e-6);
    }
}

TEST(Gcpw_ColorMoments, weights_count_as_samples_do)
{
    const ColorMoments once = momentsOf(200, 0.7, 0.1, 0.2);
    ColorMoments sum;
    sum.add(once, 0.5);
    sum.add(once, 1.5);
    EXPECT_NEAR(sum.samples(), 400, 1e-9);
    EXPECT_NEAR(sum.sourceMean(1), once.sourceMean(1), 1e-12);
    EXPECT_NEAR(sum.targetVariance(2), once.targetVariance(2), 1e-12);
}

TEST(Gcpw_ColorMoments, the_weight_follows_the_correlation)
{
    EXPECT_NEAR(correlationWeight(momentsOf(500, 0.7, 0.1, 0)), 1, 1e-6);
    EXPECT_NEAR(correlationWeight(momentsOf(500, -0.7, 0.9, 0)), 0.01, 1e-9);
    EXPECT_LT(correlationWeight(momentsOf(500, 0, 0.5, 0.2)), 0.05);
    EXPECT_EQ(correlationWeight(momentsOf(500, 0, 0.5, 0)), 1) << "flat: its mean is worth as much as any";
    const double half = correlationWeight(momentsOf(500, 0.7, 0.1, 0.2));
    EXPECT_GT(half, 0.3);
    EXPECT_LT(half, 0.9);
}

}} // namespace
