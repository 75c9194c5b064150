// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#include <gtest/gtest.h>
#include "common/exit_code.hpp"
#include "common/input_list.hpp"
#include "scratch_folder.hpp"

namespace
{

TEST(InputList, numbers_come_in_the_order_of_their_values)
{
    EXPECT_TRUE(comesBefore("IMG_9.jpg", "IMG_10.jpg"));
    EXPECT_FALSE(comesBefore("IMG_10.jpg", "IMG_9.jpg"));
    EXPECT_TRUE(comesBefore("a.jpg", "B.jpg"));
    EXPECT_TRUE(comesBefore("a", "a1"));
    EXPECT_FALSE(comesBefore("a", "a"));
    EXPECT_NE(comesBefore("a01", "a1"), comesBefore("a1", "a01"));
    EXPECT_TRUE(comesBefore("x99999999999999999998", "x99999999999999999999"));
}

TEST(InputList, a_file_is_taken_whatever_its_name_looks_like)
{
    const ScratchFolder folder;
    for (const char* name : {"@x.jpg", "a*b.jpg", "[1].jpg"})
    {
        folder.write(name, "x");
        EXPECT_EQ(listPhotographs({folder.path(name)}), std::vector<std::string>{folder.path(name)});
    }
}

TEST(InputList, folders_patterns_and_lists_stand_for_their_pictures_once)
{
    const ScratchFolder folder;
    for (const char* name : {"10.jpg", "9.JPG", ".hidden.jpg", "text.txt"})
        folder.write(name, "x");
    folder.write("list.txt", "# two\n\n  9.JPG\r\n10.jpg\n");
    const std::vector<std::string> both = {folder.path("9.JPG"), folder.path("10.jpg")};
    EXPECT_EQ(listPhotographs({folder.path("")}).size(), both.size());
    EXPECT_EQ(listPhotographs({folder.path("*.[jJ]*")}), both);
    EXPECT_EQ(listPhotographs({"@" + folder.path("list.txt")}), both);
    EXPECT_EQ(listPhotographs({both[0], "@" + folder.path("list.txt"), both[1]}), both);
}

TEST(InputList, what_stands_for_nothing_is_refused)
{
    const ScratchFolder folder;
    folder.write("empty.txt", "# none\n");
    folder.write("round.txt", "@round.txt\n");
    for (const std::string& argument : {folder.path("*.jpg"), folder.path(""), "@" + folder.path("missing.txt"),
                                        "@" + folder.path("empty.txt"), "@" + folder.path("round.txt")})
        EXPECT_THROW(listPhotographs({argument}), FileTrouble) << argument;
}

} // namespace
