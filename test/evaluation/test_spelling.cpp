// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#include <gtest/gtest.h>
#include "common/spelling.hpp"

namespace
{

const std::vector<std::string> WORDS = {"--output", "--report", "--work_megapix", "--method", "--save_model"};

TEST(Spelling, finds_the_word_with_a_letter_changed_added_dropped_or_swapped)
{
    for (const char* written : {"--outpur", "--outpput", "--ouput", "--outptu", "--OUTPUT"})
        EXPECT_EQ(nearestWord(written, WORDS), "--output") << written;
    EXPECT_EQ(nearestWord("--work-megapix", WORDS), "--work_megapix");
}

TEST(Spelling, a_beginning_is_enough)
{
    EXPECT_EQ(nearestWord("--sav", WORDS), "--save_model");
}

TEST(Spelling, what_is_like_no_word_has_none)
{
    EXPECT_EQ(nearestWord("--zebra", WORDS), "");
    EXPECT_EQ(nearestWord("--output", {}), "");
}

TEST(Spelling, lists_end_with_or)
{
    EXPECT_EQ(listed({}), "");
    EXPECT_EQ(listed({"a"}), "a");
    EXPECT_EQ(listed({"a", "b", "c"}), "a, b or c");
}

} // namespace
