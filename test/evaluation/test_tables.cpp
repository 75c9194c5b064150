// Part of the GCPW module for OpenCV. Licence: Apache-2.0 (see LICENSE).
#include <cmath>
#include <gtest/gtest.h>
#include "evaluation/tables.hpp"

namespace
{

using evaluation::RunResult;
using evaluation::RunTable;

const std::vector<const evaluation::PairMethod*> METHODS = {evaluation::findPairMethod("dfw"), evaluation::findPairMethod("ros_mfw"),
                                                            evaluation::findPairMethod("gcpw")};

void add(RunTable& rows, const char* pair, const char* method, int degree, double zncc, int folds = 0)
{
    RunResult result;
    result.zncc = zncc;
    result.ncc = zncc / 10;
    result.folds = folds;
    result.align_ms = 100;
    rows[{pair, method, degree}] = result;
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
    const std::string page = evaluation::markdownPage(twoPairs(), METHODS);
    expectHolds(page, "| pair | DF-W | ROS+MF-W | GCPW |");
    expectHolds(page, "| door | 40.0 | 20.0 | **10.0** |");
    expectHolds(page, "| park | 60.0 | **39.0** | 40.0 |");
    expectHolds(page, "| mean of 2 | 50.0 | 29.5 | **25.0** |");
    expectHolds(page, "| geometric mean of 2 | 49.0 | 27.9 | **20.0** |");
}

TEST(Evaluation_Tables, the_place_of_gcpw_names_who_leads_instead)
{
    const std::string page = evaluation::markdownPage(twoPairs(), METHODS);
    expectHolds(page, "GCPW is first on 1 of 2 pairs, and first or within 2 % of it on 1.");
    expectHolds(page, "- park: ROS+MF-W leads, GCPW is 2.6 % behind");
}

TEST(Evaluation_Tables, a_failed_run_is_a_dash_and_its_pair_is_in_no_mean)
{
    RunTable rows = twoPairs();
    rows[{"door", "dfw", 0}].zncc = std::nan("");
    const std::string page = evaluation::markdownPage(rows, METHODS);
    expectHolds(page, "| door | - | 20.0 | **10.0** |");
    expectHolds(page, "| mean of 1 | 60.0 | **39.0** | 40.0 |");
}

TEST(Evaluation_Tables, folds_are_summed_over_all_runs)
{
    RunTable rows = twoPairs();
    add(rows, "door", "ros_mfw", 5, 25, 4);
    expectHolds(evaluation::markdownPage(rows, METHODS), "| ROS+MF-W | 3 | 7 | 2 | 100 | 100 |");
}

TEST(Evaluation_Tables, methods_blind_to_pixels_are_the_same_at_every_degree)
{
    RunTable rows = twoPairs();
    for (const char* pair : {"door", "park"})
        for (const char* method : {"ros_mfw", "gcpw"})
            add(rows, pair, method, 16, 44);
    expectHolds(evaluation::markdownPage(rows, METHODS), "| 16 | 50.00 | **44.00** | **44.00** |");
}

TEST(Evaluation_Tables, no_rows_give_a_page_without_means)
{
    const std::string page = evaluation::markdownPage(RunTable(), METHODS);
    EXPECT_EQ(page.find("mean of"), std::string::npos);
    EXPECT_EQ(page.find("nan"), std::string::npos);
}

} // namespace
