// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#include <cmath>
#include <gtest/gtest.h>
#include <opencv2/core.hpp>
#include "evaluation/spread.hpp"

namespace
{

using evaluation::Scores;

const double NONE = std::nan("");

TEST(Evaluation_Spread, the_median_is_the_middle_one_whatever_the_order)
{
    EXPECT_EQ(evaluation::median({12, 22, 15, 20, 19}), 19);
    EXPECT_EQ(evaluation::median({4, 1, 3, 2}), 2.5);
    EXPECT_EQ(evaluation::median({7}), 7);
}

TEST(Evaluation_Spread, a_run_without_a_score_counts_as_the_worst)
{
    EXPECT_EQ(evaluation::median({NONE, 1, 2, 3, 4}), 3);
    EXPECT_TRUE(std::isnan(evaluation::median({NONE, NONE, NONE, 1, 2})));
    EXPECT_TRUE(std::isnan(evaluation::median({1, NONE})));
    EXPECT_TRUE(std::isnan(evaluation::median({})));
    EXPECT_TRUE(std::isnan(evaluation::spread({1, NONE})));
}

TEST(Evaluation_Spread, the_spread_is_largest_over_smallest)
{
    EXPECT_DOUBLE_EQ(evaluation::spread({12, 22, 15, 20, 19}), 22.0 / 12);
    EXPECT_EQ(evaluation::spread({7}), 1);
    EXPECT_TRUE(std::isnan(evaluation::spread({0, 7})));
    EXPECT_TRUE(std::isnan(evaluation::spread({})));
}

TEST(Evaluation_Spread, a_method_is_ahead_only_if_it_is_better_on_every_input)
{
    const Scores a = {5, 4, 3};
    EXPECT_TRUE(evaluation::isAhead(a, {6, 4.5, 3.5})) << "though the ranges overlap: inputs are as hard for both";
    EXPECT_FALSE(evaluation::isAhead({6, 4.5, 3.5}, a));
    EXPECT_FALSE(evaluation::isAhead(a, {50, 40, 2.9}));
    EXPECT_FALSE(evaluation::isAhead(a, a)) << "equal is not better";
    EXPECT_TRUE(evaluation::isAhead(a, {6, NONE, 4}));
    EXPECT_FALSE(evaluation::isAhead({1, NONE, 1}, {6, NONE, 4}));
    EXPECT_FALSE(evaluation::isAhead({}, {}));
    EXPECT_THROW(evaluation::isAhead(a, {1}), cv::Exception);
}

TEST(Evaluation_Spread, a_percentile_lies_between_its_neighbours)
{
    EXPECT_EQ(evaluation::percentile({}, 95), 0);
    EXPECT_EQ(evaluation::percentile({7}, 95), 7);
    EXPECT_DOUBLE_EQ(evaluation::percentile({4, 0, 2}, 50), 2);
    EXPECT_DOUBLE_EQ(evaluation::percentile({4, 0, 2}, 75), 3);
    EXPECT_EQ(evaluation::percentile({4, 0, 2}, 100), 4);
    EXPECT_THROW(evaluation::percentile({1}, 101), cv::Exception);
}

} // namespace
