// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#include <cmath>
#include <opencv2/core.hpp>
#include "evaluation/results.hpp"
#include "scratch_folder.hpp"

namespace
{

using evaluation::ResultsFile;
using evaluation::RunKey;
using evaluation::RunResult;
using evaluation::RunTable;

const std::vector<std::string> OPTIONS = {"max_megapix=0.48", "meshCols=32"};

RunResult scored(double zncc)
{
    RunResult result;
    result.ncc = zncc / 10;
    result.zncc = zncc;
    result.folds = 2;
    result.align_ms = 12.5;
    return result;
}

std::string complaint(const std::string& folder, const std::vector<std::string>& options)
{
    try
    {
        ResultsFile(folder, options, false);
    }
    catch (const cv::Exception& error)
    {
        return error.err;
    }
    return std::string();
}

TEST(Evaluation_Results, rows_come_back_as_they_were)
{
    const ScratchFolder folder;
    RunResult failed = scored(std::nan(""));
    failed.status = "failed";
    {
        ResultsFile results(folder.path(), OPTIONS, false);
        results.append({"b", "gcpw", 16}, scored(12.25));
        results.append({"a", "dfw", 0}, failed);
    }
    const ResultsFile results(folder.path(), OPTIONS, false);
    const RunTable rows = results.rows();
    ASSERT_EQ(rows.size(), 2u);
    EXPECT_TRUE(results.has({"b", "gcpw", 16}));
    EXPECT_FALSE(results.has({"b", "gcpw", 1}));
    const RunResult& row = rows.at({"b", "gcpw", 16});
    EXPECT_EQ(row.status, "ok");
    EXPECT_DOUBLE_EQ(row.zncc, 12.25);
    EXPECT_DOUBLE_EQ(row.ncc, 1.225);
    EXPECT_EQ(row.folds, 2);
    EXPECT_DOUBLE_EQ(row.align_ms, 12.5);
    EXPECT_EQ(rows.at({"a", "dfw", 0}).status, "failed");
    EXPECT_TRUE(std::isnan(rows.at({"a", "dfw", 0}).zncc));
}

TEST(Evaluation_Results, a_row_is_in_the_file_as_soon_as_it_is_appended)
{
    const ScratchFolder folder;
    ResultsFile results(folder.path(), OPTIONS, false);
    results.append({"a", "gcpw", 0}, scored(7));
    EXPECT_NE(folder.read("results.csv").find("a,gcpw,00,1,ok,0.700000,7.000000,2,12.5,0.0,,,,,,,\n"), std::string::npos);
}

TEST(Evaluation_Results, what_was_not_measured_is_empty_and_comes_back_as_nothing)
{
    const ScratchFolder folder;
    {
        ResultsFile results(folder.path(), OPTIONS, false);
        RunResult seen = scored(7);
        seen.bend_p95 = 0.25;
        seen.crushed = 3;
        results.append({"a", "gcpw", 0}, seen);
    }
    const std::string text = folder.read("results.csv");
    EXPECT_EQ(text.find("pair,method,degree,input,status,ncc,zncc,folds,align_ms,match_ms,bend_p95,"), 0u) << text;
    EXPECT_NE(text.find(",12.5,0.0,0.250000,,,,,,3.000000\n"), std::string::npos) << text;
    const RunTable rows = ResultsFile(folder.path(), OPTIONS, false).rows();
    EXPECT_DOUBLE_EQ(rows.at({"a", "gcpw", 0}).bend_p95, 0.25);
    EXPECT_DOUBLE_EQ(rows.at({"a", "gcpw", 0}).crushed, 3);
    EXPECT_TRUE(std::isnan(rows.at({"a", "gcpw", 0}).seam_worst));
    folder.write("results.csv", text.substr(0, text.size() - 9) + "much\n");
    EXPECT_NE(complaint(folder.path(), OPTIONS).find("'much' is no crushed"), std::string::npos) << complaint(folder.path(), OPTIONS);
}

TEST(Evaluation_Results, a_row_cut_by_an_interruption_is_made_again_and_the_table_is_the_same)
{
    const ScratchFolder folder;
    const auto fill = [&](bool fresh)
    {
        ResultsFile results(folder.path(), OPTIONS, fresh);
        int made = 0;
        for (int degree = 4; degree >= 0; --degree)
            if (!results.has({"a", "gcpw", degree}))
            {
                results.append({"a", "gcpw", degree}, scored(10 + degree));
                ++made;
            }
        results.sort();
        return made;
    };
    EXPECT_EQ(fill(true), 5);
    const std::string whole = folder.read("results.csv");
    for (const size_t length : {whole.size() - 3, whole.size() - 40, whole.size() - 90, whole.find('\n') + 1})
    {
        folder.write("results.csv", whole.substr(0, length));
        EXPECT_GT(fill(false), 0) << length;
        EXPECT_EQ(folder.read("results.csv"), whole) << length;
    }
}

TEST(Evaluation_Results, the_order_of_the_file_does_not_tell_who_was_first)
{
    const ScratchFolder folder;
    std::string texts[2];
    for (int turn = 0; turn < 2; ++turn)
    {
        ResultsFile results(folder.path(), OPTIONS, true);
        for (int i = 0; i < 6; ++i)
        {
            const int k = turn ? 5 - i : i;
            results.append({k % 2 ? "a" : "b", "gcpw", k}, scored(k));
        }
        results.sort();
        texts[turn] = folder.read("results.csv");
    }
    EXPECT_EQ(texts[0], texts[1]);
}

TEST(Evaluation_Results, other_options_are_refused_and_named)
{
    const ScratchFolder folder;
    ResultsFile(folder.path(), OPTIONS, false).append({"a", "gcpw", 0}, scored(7));
    EXPECT_EQ(complaint(folder.path(), OPTIONS), "");
    const std::string changed = complaint(folder.path(), {"max_megapix=0.3", "meshCols=32"});
    EXPECT_NE(changed.find("max_megapix was 0.48, is 0.3"), std::string::npos) << changed;
    EXPECT_NE(changed.find("--fresh"), std::string::npos) << changed;
    const std::string fewer = complaint(folder.path(), {"max_megapix=0.48"});
    EXPECT_NE(fewer.find("meshCols was 32, is not there"), std::string::npos) << fewer;
    EXPECT_EQ(ResultsFile(folder.path(), {"max_megapix=0.3"}, true).rows().size(), 0u);
}

TEST(Evaluation_Results, a_file_that_is_no_table_is_refused_with_its_line)
{
    const ScratchFolder folder;
    { const ResultsFile results(folder.path(), OPTIONS, false); }
    const std::string head = folder.read("results.csv");
    folder.write("results.csv", head + "no row\na,gcpw,00,1,ok,1,2,0,1,1\n");
    EXPECT_NE(complaint(folder.path(), OPTIONS).find("line 2"), std::string::npos);
    folder.write("results.csv", "something else\n");
    EXPECT_NE(complaint(folder.path(), OPTIONS).find("line 1"), std::string::npos);
}

} // namespace
