// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#include <cmath>
#include <cstring>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>
#include <sys/mman.h>
#include "evaluation/child_process.hpp"
#include "evaluation/image_sets.hpp"
#include "scratch_folder.hpp"

namespace
{

using evaluation::SetScore;

/// Windows of one picture, dumped as if they were warped images; the second is spoiled as the test wants.
class Evaluation_ScoreDump : public ::testing::Test
{
protected:
    void SetUp() override
    {
        picture_ = cv::Mat(150, 300, CV_8UC3);
        cv::RNG(5).fill(picture_, cv::RNG::UNIFORM, 30, 200);
        cv::GaussianBlur(picture_, picture_, cv::Size(), 1.5);
    }

    void dump(int k, cv::Rect place, cv::Point offset = cv::Point(), int brightness = 0)
    {
        const cv::Mat image = picture_(place + offset).clone();
        write(k, "image", image);
        write(k, "corrected", image + cv::Scalar::all(brightness));
        write(k, "mask", cv::Mat(image.size(), CV_8UC1, cv::Scalar(255)));
        corners_ += cv::format("%03d,%d,%d\n", k, place.x, place.y);
        folder_.write("corners.csv", corners_);
    }

    void write(int k, const std::string& what, const cv::Mat& image) const
    {
        cv::imwrite(folder_.path(cv::format("%03d_", k) + what + ".png"), image);
    }

    ScratchFolder folder_;
    cv::Mat picture_;
    std::string corners_;
};

TEST_F(Evaluation_ScoreDump, windows_in_their_places_are_perfect)
{
    dump(0, cv::Rect(0, 0, 150, 120));
    dump(1, cv::Rect(80, 10, 150, 120));
    dump(2, cv::Rect(225, 0, 75, 120)); // overlaps in less than counts
    const SetScore score = evaluation::scoreDump(folder_.path());
    EXPECT_EQ(score.images, 3);
    EXPECT_EQ(score.pairs, 1);
    EXPECT_LT(score.zncc, 1e-3);
    EXPECT_LT(score.ncc, 1e-3);
    EXPECT_EQ(score.color_difference, 0);
}

TEST_F(Evaluation_ScoreDump, a_shift_shows_in_the_correlation_and_brightness_in_the_colours)
{
    dump(0, cv::Rect(0, 0, 150, 120));
    dump(1, cv::Rect(80, 10, 150, 120), cv::Point(2, 0), 20);
    const SetScore score = evaluation::scoreDump(folder_.path());
    EXPECT_GT(score.zncc, 10);
    EXPECT_GT(score.color_difference, 15);
    EXPECT_LT(score.color_difference, 60);
}

TEST_F(Evaluation_ScoreDump, what_a_mask_hides_does_not_count)
{
    dump(0, cv::Rect(0, 0, 150, 120));
    dump(1, cv::Rect(80, 10, 150, 120));
    cv::Mat image = picture_(cv::Rect(80, 10, 150, 120)).clone();
    cv::Mat mask(image.size(), CV_8UC1, cv::Scalar(255));
    const cv::Rect hidden(0, 0, 30, 120);
    image(hidden).setTo(0);
    mask(hidden).setTo(0);
    write(1, "image", image);
    write(1, "corrected", image);
    write(1, "mask", mask);
    const SetScore score = evaluation::scoreDump(folder_.path());
    EXPECT_LT(score.zncc, 1e-3);
    EXPECT_EQ(score.color_difference, 0);
}

TEST_F(Evaluation_ScoreDump, images_that_do_not_meet_have_no_score)
{
    dump(0, cv::Rect(0, 0, 100, 120));
    dump(1, cv::Rect(150, 0, 100, 120));
    const SetScore score = evaluation::scoreDump(folder_.path());
    EXPECT_EQ(score.pairs, 0);
    EXPECT_TRUE(std::isnan(score.zncc));
}

TEST_F(Evaluation_ScoreDump, a_missing_part_is_named)
{
    EXPECT_THROW(evaluation::scoreDump(folder_.path()), cv::Exception);
    dump(0, cv::Rect(0, 0, 100, 120));
    std::filesystem::remove(folder_.path("000_corrected.png"));
    try
    {
        evaluation::scoreDump(folder_.path());
        FAIL();
    }
    catch (const cv::Exception& error)
    {
        EXPECT_NE(error.err.find("000_corrected.png"), std::string::npos) << error.err;
    }
}

TEST(Evaluation_ImageSets, a_set_is_a_folder_of_two_images_or_more)
{
    const ScratchFolder folder;
    EXPECT_THROW(evaluation::findSets(folder.path("none")), cv::Exception);
    const cv::Mat image(20, 20, CV_8UC3, cv::Scalar::all(9));
    for (const char* name : {"lonely/01.png", "street/02.png", "street/01.png"})
    {
        folder.write(name, "");
        cv::imwrite(folder.path(name), image);
    }
    folder.write("street/notes.txt", "no image");
    const std::vector<evaluation::ImageSet> sets = evaluation::findSets(folder.path());
    ASSERT_EQ(sets.size(), 1u);
    EXPECT_EQ(sets[0].name, "street");
    ASSERT_EQ(sets[0].images.size(), 2u);
    EXPECT_LT(sets[0].images[0], sets[0].images[1]);
}

TEST(Evaluation_ImageSets, a_name_that_cannot_stand_in_a_table_is_refused)
{
    const cv::Mat image(20, 20, CV_8UC3, cv::Scalar::all(9));
    for (const char* name : {"a,b", "a|b", "a\nb"})
    {
        const ScratchFolder folder;
        for (const char* file : {"/01.png", "/02.png"})
        {
            folder.write(std::string(name) + file, "");
            cv::imwrite(folder.path(std::string(name) + file), image);
        }
        try
        {
            evaluation::findSets(folder.path());
            FAIL() << name;
        }
        catch (const cv::Exception& error)
        {
            EXPECT_NE(error.err.find("must not hold , or |"), std::string::npos) << error.err;
        }
    }
}

TEST(Evaluation_ChildProcess, exit_code_time_and_memory_are_known)
{
    EXPECT_EQ(evaluation::runChild("/bin/sh", {"-c", "exit 3"}).exit_code, 3);
    EXPECT_EQ(evaluation::runChild("/bin/sh", {"-c", "kill -9 $$"}).exit_code, 137);
    const evaluation::ChildResult result = evaluation::runChild("/bin/sh", {"-c", "sleep 0.05"});
    EXPECT_GE(result.seconds, 0.04);
    EXPECT_GT(result.peak_mb, 0.1);
    EXPECT_THROW(evaluation::runChild("/no/such/program", {}), cv::Exception);
}

TEST(Evaluation_ChildProcess, the_memory_of_a_child_is_not_that_of_its_parent)
{
    const double own = evaluation::runChild("/bin/true", {}).peak_mb;
    const size_t size = size_t(300) << 20; // used and given back; mapped, so that no allocator keeps it
    void* const large = mmap(nullptr, size, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
    ASSERT_NE(large, MAP_FAILED);
    std::memset(large, 1, size);
    ASSERT_EQ(munmap(large, size), 0);
    EXPECT_LT(evaluation::runChild("/bin/true", {}).peak_mb, own + 100);
}

} // namespace
