// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#include <cmath>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>
#include "common/synthetic_pair.hpp"
#include "evaluation/contact_sheet.hpp"
#include "evaluation/experiment.hpp"
#include "scratch_folder.hpp"

namespace
{

using evaluation::Experiment;
using evaluation::ResultsFile;
using evaluation::RunTable;

/// Two small pairs in a folder, and an experiment on them.
class Evaluation_Experiment : public ::testing::Test
{
protected:
    void SetUp() override
    {
        cv::Mat source;
        cv::Mat target;
        makeSyntheticPair(source, target);
        cv::resize(source, source, cv::Size(), 0.5, 0.5, cv::INTER_AREA);
        cv::resize(target, target, cv::Size(), 0.5, 0.5, cv::INTER_AREA);
        for (const char* name : {"one", "two"})
        {
            evaluation::makeFolder(folder_.path("pairs") + "/" + name);
            const bool swapped = std::string(name) == "two";
            cv::imwrite(folder_.path("pairs") + "/" + name + "/01.png", swapped ? target : source);
            cv::imwrite(folder_.path("pairs") + "/" + name + "/02.png", swapped ? source : target);
        }
        std::vector<std::string> complaints;
        experiment_.pairs = evaluation::findPairs(folder_.path("pairs"), complaints);
        experiment_.methods = {evaluation::findPairMethod("dfw"), evaluation::findPairMethod("gcpw")};
        experiment_.degrees = {0, 16};
        experiment_.inputs = 1;
    }

    /// Runs what is missing in a folder; returns how many runs that were.
    int run(const std::string& name)
    {
        experiment_.folder = folder_.path(name);
        ResultsFile results(experiment_.folder, {}, false);
        int runs = 0;
        const std::vector<std::string> complaints = evaluation::run(experiment_, results, [&](int, int) { ++runs; });
        EXPECT_TRUE(complaints.empty());
        rows_ = results.rows();
        return runs;
    }

    ScratchFolder folder_;
    Experiment experiment_;
    RunTable rows_;
};

TEST_F(Evaluation_Experiment, results_are_the_same_with_any_number_of_workers)
{
    EXPECT_EQ(run("alone"), 6); // DF-W does not look at pixels: one degree is enough
    const RunTable alone = rows_;
    experiment_.workers = 3;
    EXPECT_EQ(run("crew"), 6);
    ASSERT_EQ(alone.size(), rows_.size());
    for (const auto& row : alone)
    {
        const evaluation::RunResult& other = rows_.at(row.first);
        EXPECT_EQ(row.second.zncc, other.zncc);
        EXPECT_EQ(row.second.ncc, other.ncc);
        EXPECT_EQ(row.second.folds, other.folds);
    }
}

TEST_F(Evaluation_Experiment, an_interrupted_one_goes_on_where_it_was)
{
    EXPECT_EQ(run("whole"), 6);
    const RunTable whole = rows_;
    std::string text = folder_.read("whole/results.csv");
    for (int dropped = 0; dropped < 3; ++dropped)
        text.erase(text.rfind('\n', text.size() - 2) + 1);
    folder_.write("whole/results.csv", text);
    EXPECT_EQ(run("whole"), 3);
    for (const auto& row : whole)
        EXPECT_EQ(row.second.zncc, rows_.at(row.first).zncc);
    EXPECT_EQ(run("whole"), 0);
}

TEST_F(Evaluation_Experiment, each_input_is_a_run_of_its_own_and_the_first_is_as_it_is_alone)
{
    experiment_.degrees = {0};
    EXPECT_EQ(run("given"), 4);
    const RunTable given = rows_;
    experiment_.inputs = 3;
    EXPECT_EQ(run("three"), 12);
    for (const auto& row : given)
        EXPECT_EQ(row.second.zncc, rows_.at(row.first).zncc);
    for (const int input : {2, 3})
    {
        const double zncc = rows_.at({"one", "gcpw", 0, input}).zncc;
        EXPECT_TRUE(std::isfinite(zncc));
        EXPECT_NE(zncc, rows_.at({"one", "gcpw", 0, 1}).zncc) << input;
    }
    EXPECT_EQ(run("given"), 8) << "further inputs are added to those that are there";
}

TEST_F(Evaluation_Experiment, inputs_that_there_are_not_are_refused)
{
    for (const int inputs : {0, 6})
    {
        experiment_.inputs = inputs;
        EXPECT_THROW(run("none"), cv::Exception) << inputs;
    }
}

TEST_F(Evaluation_Experiment, a_photograph_that_cannot_be_read_is_named_once_and_the_other_pairs_go_on)
{
    const std::string photograph = folder_.path("pairs/one/01.png");
    std::filesystem::rename(photograph, folder_.path("kept.png"));
    folder_.write("pairs/one/01.png", "no picture");
    experiment_.workers = 2;
    experiment_.inputs = 2;
    experiment_.degrees = {0};
    experiment_.folder = folder_.path("broken");
    ResultsFile results(experiment_.folder, {}, false);
    int last = 0;
    const std::vector<std::string> complaints = evaluation::run(experiment_, results, [&](int done, int) { last = done; });
    ASSERT_EQ(complaints.size(), 1u);
    EXPECT_NE(complaints[0].find("01.png"), std::string::npos) << complaints[0];
    EXPECT_EQ(last, 8);
    EXPECT_EQ(results.rows().size(), 4u);
    EXPECT_TRUE(results.has({"two", "gcpw", 0, 2}));

    // Mended, it is tried again.
    std::filesystem::rename(folder_.path("kept.png"), photograph);
    EXPECT_TRUE(evaluation::run(experiment_, results, evaluation::RunCallback()).empty());
    EXPECT_EQ(results.rows().size(), 8u);
}

TEST_F(Evaluation_Experiment, photographs_that_do_not_match_are_rows_without_scores)
{
    cv::imwrite(folder_.path("pairs/two/01.png"), cv::Mat(200, 300, CV_8UC3, cv::Scalar::all(90)));
    experiment_.folder = folder_.path("unmatched");
    ResultsFile results(experiment_.folder, {}, false);
    const std::vector<std::string> complaints = evaluation::run(experiment_, results, evaluation::RunCallback());
    EXPECT_EQ(complaints.size(), 3u);
    EXPECT_EQ(results.rows().at({"two", "gcpw", 0}).status, "no_alignment");
    EXPECT_TRUE(std::isnan(results.rows().at({"two", "gcpw", 0}).zncc));
    EXPECT_EQ(results.rows().at({"one", "gcpw", 0}).status, "ok");
    EXPECT_TRUE(evaluation::contactSheet(experiment_, experiment_.pairs[1], results.rows()).empty());
}

TEST_F(Evaluation_Experiment, a_contact_sheet_has_a_row_for_each_method)
{
    run("sheet");
    const cv::Mat both = evaluation::contactSheet(experiment_, experiment_.pairs[0], rows_);
    experiment_.methods.pop_back();
    const cv::Mat one = evaluation::contactSheet(experiment_, experiment_.pairs[0], rows_);
    ASSERT_FALSE(one.empty());
    EXPECT_EQ(both.rows, 2 * one.rows);
}

TEST(Evaluation_ContactSheet, the_worst_patch_is_where_the_images_differ)
{
    cv::RNG random(3);
    cv::gcpw::PairCanvas canvas;
    canvas.target = cv::Mat(200, 300, CV_8UC3);
    random.fill(canvas.target, cv::RNG::UNIFORM, 0, 256);
    cv::GaussianBlur(canvas.target, canvas.target, cv::Size(), 1.5);
    canvas.source = canvas.target.clone();
    const cv::Rect spoiled(180, 90, 40, 40);
    cv::flip(canvas.target(spoiled), canvas.source(spoiled), -1);
    canvas.source_mask = canvas.target_mask = cv::Mat(canvas.target.size(), CV_8UC1, cv::Scalar(255));
    const std::vector<cv::Rect> worst = evaluation::worstPatches({canvas, canvas}, canvas.target.size(), 40, 3);
    ASSERT_EQ(worst.size(), 3u);
    EXPECT_GT((worst[0] & spoiled).area(), spoiled.area() / 2);
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < i; ++j)
            EXPECT_EQ((worst[i] & worst[j]).area(), 0);
}

TEST(Evaluation_PairFolder, a_folder_without_pairs_is_refused_with_its_name)
{
    const ScratchFolder folder;
    std::vector<std::string> complaints;
    EXPECT_THROW(evaluation::findPairs(folder.path("none"), complaints), cv::Exception);
    EXPECT_THROW(evaluation::findPairs(folder.path(), complaints), cv::Exception);
    folder.write("half/01.png", "");
    EXPECT_THROW(evaluation::findPairs(folder.path(), complaints), cv::Exception);
}

TEST(Evaluation_PairFolder, half_a_pair_is_told_and_does_not_stop_the_others)
{
    const ScratchFolder folder;
    for (const char* name : {"half/01.png", "whole/01.png", "whole/02.jpg"})
        folder.write(name, "");
    std::vector<std::string> complaints;
    const std::vector<evaluation::PairFiles> pairs = evaluation::findPairs(folder.path(), complaints);
    ASSERT_EQ(pairs.size(), 1u);
    EXPECT_EQ(pairs[0].name, "whole");
    ASSERT_EQ(complaints.size(), 1u);
    EXPECT_NE(complaints[0].find("half"), std::string::npos) << complaints[0];
}

TEST(Evaluation_PairFolder, a_name_that_cannot_stand_in_a_table_is_refused)
{
    for (const char* name : {"a,b", "a|b", "a\nb"})
    {
        const ScratchFolder folder;
        folder.write(std::string(name) + "/01.png", "");
        folder.write(std::string(name) + "/02.png", "");
        std::vector<std::string> complaints;
        EXPECT_THROW(evaluation::findPairs(folder.path(), complaints), cv::Exception) << name;
    }
}

} // namespace
