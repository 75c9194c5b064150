// Part of the GCPW module for OpenCV. Licence: Apache-2.0 (see LICENSE).
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
        experiment_.pairs = evaluation::findPairs(folder_.path("pairs"));
        experiment_.methods = {evaluation::findPairMethod("dfw"), evaluation::findPairMethod("gcpw")};
        experiment_.degrees = {0, 16};
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

TEST_F(Evaluation_Experiment, a_missing_photograph_is_named)
{
    folder_.write("pairs/two/01.png", "no picture");
    experiment_.workers = 2;
    try
    {
        run("broken");
        FAIL();
    }
    catch (const cv::Exception& error)
    {
        EXPECT_NE(error.err.find("01.png"), std::string::npos) << error.err;
    }
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
    EXPECT_THROW(evaluation::findPairs(folder.path("none")), cv::Exception);
    EXPECT_THROW(evaluation::findPairs(folder.path()), cv::Exception);
    folder.write("half/01.png", "");
    EXPECT_THROW(evaluation::findPairs(folder.path()), cv::Exception);
    folder.write("half/02.jpg", "");
    EXPECT_EQ(evaluation::findPairs(folder.path()).size(), 1u);
}

TEST(Evaluation_PairFolder, photographs_are_scaled_down_but_never_up)
{
    const ScratchFolder folder;
    cv::imwrite(folder.path("a.png"), cv::Mat(300, 400, CV_8UC1, cv::Scalar(7)));
    EXPECT_EQ(evaluation::readCapped(folder.path("a.png"), 1).size(), cv::Size(400, 300));
    EXPECT_EQ(evaluation::readCapped(folder.path("a.png"), 0.03).size(), cv::Size(200, 150));
    EXPECT_EQ(evaluation::readCapped(folder.path("a.png"), 1).type(), CV_8UC3);
    EXPECT_THROW(evaluation::readCapped(folder.path("a.png"), 0), cv::Exception);
    EXPECT_THROW(evaluation::readCapped(folder.path("b.png"), 1), cv::Exception);
}

} // namespace
