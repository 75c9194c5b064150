// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#include <cmath>
#include <gtest/gtest.h>
#include "evaluation/tables.hpp"

namespace
{

using evaluation::RunResult;
using evaluation::RunTable;

const std::vector<const evaluation::PairMethod*> METHODS = {evaluation::findPairMethod("dfw"), evaluation::findPairMethod("ros_mfw"),
                                                            evaluation::findPairMethod("gcpw")};

void add(RunTable& rows, const char* pair, const std::string& method, int degree, double zncc, int folds = 0,
         int input = 1)
{
    RunResult result;
    result.zncc = zncc;
    result.ncc = zncc / 10;
    result.folds = folds;
    result.align_ms = 100;
    rows[{pair, method, degree, input}] = result;
}

RunTable twoPairs()
{
    RunTable rows;
    add(rows, "door", "dfw", 0, 40);
    add(rows, "door", "ros_mfw", 0, 20, 3);
    add(rows, "door", "gcpw", 0, 10);
    add(rows, "park", "dfw", 0, 60);
    add(rows, "park", "ros_mfw", 0, 39);
    add(rows, "park", "gcpw", 0, 40);
    return rows;
}

void expectHolds(const std::string& page, const std::string& line)
{
    EXPECT_NE(page.find(line + "\n"), std::string::npos) << "no line " << line << " in\n" << page;
}

TEST(Evaluation_Tables, rows_have_every_method_the_least_in_bold_and_both_means)
{
    const std::string page = evaluation::markdownPage(twoPairs(), METHODS, 1);
    expectHolds(page, "| pair | DF-W | ROS+MF-W | GCPW |");
    expectHolds(page, "| door | 40.0 | 20.0 | **10.0** |");
    expectHolds(page, "| park | 60.0 | **39.0** | 40.0 |");
    expectHolds(page, "| mean of 2 | 50.0 | 29.5 | **25.0** |");
    expectHolds(page, "| geometric mean of 2 | 49.0 | 27.9 | **20.0** |");
}

TEST(Evaluation_Tables, the_place_of_gcpw_names_who_is_ahead)
{
    const std::string page = evaluation::markdownPage(twoPairs(), METHODS, 1);
    expectHolds(page, "GCPW is ahead of all others on 1 of 2 pairs, level with the best on 0, behind on 1.");
    expectHolds(page, "- park: behind ROS+MF-W (by 3 %)");
    EXPECT_EQ(page.find("spread of zncc"), std::string::npos) << "one input has no spread";
}

/// Three inputs of two pairs: on "door" ROS+MF-W has the lower median, but not on every input; on "park" GCPW is ahead.
RunTable threeInputs()
{
    RunTable rows;
    const double door[3][3] = {{40, 30, 50}, {20, 10, 15}, {22, 9, 16}};
    const double park[3][3] = {{40, 30, 50}, {20, 30, 40}, {19, 29, 39}};
    for (size_t m = 0; m < METHODS.size(); ++m)
        for (int i = 0; i < 3; ++i)
        {
            add(rows, "door", METHODS[m]->name, 0, door[m][i], 0, i + 1);
            add(rows, "park", METHODS[m]->name, 0, park[m][i], 0, i + 1);
        }
    return rows;
}

TEST(Evaluation_Tables, cells_are_medians_and_what_is_not_behind_on_every_input_is_bold_too)
{
    const std::string page = evaluation::markdownPage(threeInputs(), METHODS, 3);
    expectHolds(page, "| door | 40.0 | **15.0** | **16.0** |");
    expectHolds(page, "| park | 40.0 | 30.0 | **29.0** |");
    expectHolds(page, "| mean of 2 | 40.0 | **22.5** | **22.5** |");
    expectHolds(page, "GCPW is ahead of all others on 1 of 2 pairs, level with the best on 1, behind on 0.");
    expectHolds(page, "- door: level with ROS+MF-W");
    EXPECT_EQ(page.find("- park"), std::string::npos);
}

TEST(Evaluation_Tables, the_spread_is_told_beside_the_medians)
{
    const std::string page = evaluation::markdownPage(threeInputs(), METHODS, 3);
    expectHolds(page, "| door | 1.67 | 2.00 | 2.44 |");
    expectHolds(page, "| park | 1.67 | 2.00 | 2.05 |");
}

TEST(Evaluation_Tables, further_inputs_in_the_rows_are_left_out)
{
    RunTable rows = twoPairs();
    add(rows, "door", "gcpw", 0, 99, 5, 2);
    const std::string page = evaluation::markdownPage(rows, METHODS, 1);
    expectHolds(page, "| door | 40.0 | 20.0 | **10.0** |");
    expectHolds(page, "| GCPW | 2 | 0 | 0 | 100 | 100 |");
    EXPECT_THROW(evaluation::markdownPage(rows, METHODS, 0), cv::Exception);
    EXPECT_THROW(evaluation::markdownPage(rows, METHODS, 6), cv::Exception);
}

TEST(Evaluation_Tables, appearance_is_the_mean_of_medians_of_pairs_that_all_have)
{
    RunTable rows = threeInputs();
    EXPECT_EQ(evaluation::markdownPage(rows, METHODS, 3).find("appearance"), std::string::npos) << "never measured";
    int turn = 0;
    for (auto& row : rows)
    {
        const bool door = row.first.pair == "door";
        row.second.bend_p95 = (door ? 1 : 3) + (row.first.input == 2 ? 0.5 : 0) + (row.first.input == 3 ? 90 : 0);
        if (door && row.first.input != 3) // no cut on one of the inputs: nothing, not the worst
            row.second.seam_worst = row.first.input == 1 ? 0.2 : 0.3;
        row.second.cast = ++turn;
    }
    const std::string page = evaluation::markdownPage(rows, METHODS, 3);
    expectHolds(page, "| mean over pairs | bend p95, px | bent, % | shape | seam p95 | seam worst | cast | crushed, % |");
    expectHolds(page, "| DF-W | 2.50 | - | - | - | 0.25 | 6.5 | - |");
    expectHolds(page, "| pairs that all have | 2 | 0 | 0 | 0 | 1 | 2 | 0 |");
    expectHolds(page, "| pair, GCPW | bend p95, px | bent, % | shape | seam p95 | seam worst | cast | crushed, % |");
    expectHolds(page, "| door | 1.50 | - | - | - | 0.25 | 5.0 | - |");
    expectHolds(page, "| park | 3.50 | - | - | - | - | 14.0 | - |");
}

TEST(Evaluation_Tables, a_failed_run_is_a_dash_and_its_pair_is_in_no_mean)
{
    RunTable rows = twoPairs();
    rows[{"door", "dfw", 0}].zncc = std::nan("");
    const std::string page = evaluation::markdownPage(rows, METHODS, 1);
    expectHolds(page, "| door | - | 20.0 | **10.0** |");
    expectHolds(page, "| mean of 1 | 60.0 | **39.0** | 40.0 |");
}

TEST(Evaluation_Tables, folds_are_summed_over_all_runs)
{
    RunTable rows = twoPairs();
    add(rows, "door", "ros_mfw", 5, 25, 4);
    expectHolds(evaluation::markdownPage(rows, METHODS, 1), "| ROS+MF-W | 3 | 7 | 2 | 100 | 100 |");
}

TEST(Evaluation_Tables, methods_blind_to_pixels_are_the_same_at_every_degree)
{
    RunTable rows = twoPairs();
    for (const char* pair : {"door", "park"})
        for (const char* method : {"ros_mfw", "gcpw"})
            add(rows, pair, method, 16, 44);
    expectHolds(evaluation::markdownPage(rows, METHODS, 1), "| 16 | 50.00 | **44.00** | **44.00** |");
}

TEST(Evaluation_Tables, no_rows_give_a_page_without_means)
{
    const std::string page = evaluation::markdownPage(RunTable(), METHODS, 1);
    EXPECT_EQ(page.find("mean of"), std::string::npos);
    EXPECT_EQ(page.find("nan"), std::string::npos);
}

} // namespace
