// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#include <gtest/gtest.h>
#include "common/progress_line.hpp"

namespace
{

TEST(ProgressLine, the_time_left_is_that_of_the_rest_at_the_same_pace)
{
    EXPECT_EQ(ProgressLine::timeLeft(0.5, 65), "1:05 left");
    EXPECT_EQ(ProgressLine::timeLeft(0.25, 10), "0:30 left");
    EXPECT_EQ(ProgressLine::timeLeft(1, 10), "0:00 left");
}

TEST(ProgressLine, nothing_is_said_before_anything_can_be_known)
{
    EXPECT_EQ(ProgressLine::timeLeft(0.01, 100), "");
    EXPECT_EQ(ProgressLine::timeLeft(0.5, 0.2), "");
    EXPECT_EQ(ProgressLine::timeLeft(0, 0), "");
}

TEST(ProgressLine, one_that_is_not_shown_asks_for_nothing)
{
    ProgressLine line({{"a", 1}, {"b", 0}}, false);
    line.begin("b");
    line.show(0.5);
    EXPECT_FALSE(static_cast<bool>(line.callback({{"features", 1}})));
}

TEST(ProgressLine, stages_take_their_share_of_the_whole)
{
    const std::vector<ProgressLine::Stage> stages = {{"a", 1}, {"b", 3}, {"c", 4}};
    EXPECT_DOUBLE_EQ(ProgressLine::doneOf(stages, 0, 0), 0);
    EXPECT_DOUBLE_EQ(ProgressLine::doneOf(stages, 0, 1), 0.125);
    EXPECT_DOUBLE_EQ(ProgressLine::doneOf(stages, 1, 0), 0.125);
    EXPECT_DOUBLE_EQ(ProgressLine::doneOf(stages, 1, 0.5), 0.3125);
    EXPECT_DOUBLE_EQ(ProgressLine::doneOf(stages, 2, 1), 1);
}

} // namespace
