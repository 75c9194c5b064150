// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#include "test_precomp.hpp"

#include "solver/robust_loss.hpp"

namespace opencv_test { namespace {

using namespace cv::gcpw;

TEST(Gcpw_RobustLoss, without_a_scale_it_is_the_sum_of_squares)
{
    const RobustLoss loss;
    for (const double s : {0.0, 0.5, 3.0, 1e6})
    {
        EXPECT_EQ(loss.value(s), s);
        EXPECT_EQ(loss.weight(s), 1);
    }
}

TEST(Gcpw_RobustLoss, the_weight_is_the_slope)
{
    const RobustLoss loss(2.5);
    for (const double s : {0.0, 0.1, 1.0, 6.25, 100.0})
    {
        const double step = 1e-5 * (1 + s);
        EXPECT_NEAR(loss.weight(s), (loss.value(s + step) - loss.value(s - step)) / (2 * step), 1e-8);
    }
}

TEST(Gcpw_RobustLoss, small_residuals_count_in_full_and_large_ones_stop_counting)
{
    const RobustLoss loss(2);
    EXPECT_NEAR(loss.value(1e-6), 1e-6, 1e-11);
    EXPECT_NEAR(loss.weight(0), 1, 1e-12);
    EXPECT_NEAR(loss.value(4), 2, 1e-12) << "half of the most at the scale";
    EXPECT_LT(loss.value(1e12), 4);
    EXPECT_GT(loss.value(1e12), 3.999);
    EXPECT_LT(loss.weight(1e6), 1e-9);
}

}} // namespace
