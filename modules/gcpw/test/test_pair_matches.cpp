// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#include "test_precomp.hpp"

#include "scene.hpp"

namespace opencv_test { namespace {

using namespace cv::gcpw;

Params with(Method method)
{
    Params params;
    params.method = method;
    return params;
}

class Gcpw_PairMatches : public ::testing::TestWithParam<Method>
{
};

TEST_P(Gcpw_PairMatches, alignment_from_matches_is_the_alignment_that_finds_them)
{
    const Scene scene(smallScene());
    const PairMatches matches = findPairMatches(scene.source(), scene.target());
    ASSERT_EQ(matches.status, Status::OK) << matches.message;
    const Alignment direct = alignPair(scene.source(), scene.target(), with(GetParam()));
    const Alignment given = alignPair(scene.source(), scene.target(), matches, with(GetParam()));
    ASSERT_TRUE(direct.ok() && given.ok());
    EXPECT_EQ(cv::norm(direct.image(0).mesh, given.image(0).mesh, NORM_INF), 0);
    EXPECT_EQ(direct.report().pairs[0].points, given.report().pairs[0].points);
    EXPECT_EQ(direct.report().pairs[0].lines, given.report().pairs[0].lines);
}

INSTANTIATE_TEST_SUITE_P(EveryMethod, Gcpw_PairMatches,
                         ::testing::Values(Method::GLOBAL, Method::CPW, Method::DFW, Method::MFW, Method::GCPW));

TEST(Gcpw_PairMatchesInput, geometry_of_photographs_over_the_working_resolution_is_in_their_own_pixels)
{
    const Scene scene((SceneOptions()));
    Params coarse;
    coarse.workMegapix = 0.05;
    const PairMatches matches = findPairMatches(scene.source(), scene.target(), coarse);
    ASSERT_EQ(matches.status, Status::OK) << matches.message;
    ASSERT_GT(matches.source_points.size(), 20u);
    double sum = 0;
    for (size_t i = 0; i < matches.source_points.size(); ++i)
        sum += cv::norm(scene.canvasAt(matches.source_points[i]) - matches.target_points[i]);
    EXPECT_LT(sum / static_cast<double>(matches.source_points.size()), 1.0);
}

TEST(Gcpw_PairMatchesInput, a_failed_search_gives_no_alignment_and_its_message)
{
    const Mat flat(240, 320, CV_8UC3, Scalar::all(128));
    const PairMatches matches = findPairMatches(flat, flat);
    EXPECT_EQ(matches.status, Status::NO_ALIGNMENT);
    const Alignment alignment = alignPair(flat, flat, matches);
    EXPECT_EQ(alignment.report().status, Status::NO_ALIGNMENT);
    EXPECT_EQ(alignment.report().message, matches.message);
}

TEST(Gcpw_PairMatchesInput, a_mirrored_target_has_no_alignment_and_the_message_counts_none)
{
    const Scene scene(smallScene());
    Mat mirrored;
    flip(scene.source(), mirrored, 1);
    const PairMatches matches = findPairMatches(scene.source(), mirrored);
    EXPECT_EQ(matches.status, Status::NO_ALIGNMENT);
    EXPECT_NE(matches.message.find("no alignment"), std::string::npos) << matches.message;
}

TEST(Gcpw_PairMatchesInput, opencvs_random_numbers_are_neither_read_nor_moved_on)
{
    const Scene scene(smallScene());
    std::vector<PairMatches> found;
    const uint64 before = theRNG().state;
    for (const uint64 state : {uint64(1), uint64(0x123456789abcdef)})
    {
        theRNG().state = state;
        found.push_back(findPairMatches(scene.source(), scene.target()));
        EXPECT_EQ(theRNG().state, state);
    }
    theRNG().state = before;
    ASSERT_EQ(found[0].status, Status::OK) << found[0].message;
    EXPECT_EQ(cv::norm(found[0].target_from_source, found[1].target_from_source, NORM_INF), 0);
    EXPECT_TRUE(found[0].source_points == found[1].source_points);
    EXPECT_TRUE(found[0].target_points == found[1].target_points);
    EXPECT_TRUE(found[0].source_lines == found[1].source_lines);
    EXPECT_TRUE(found[0].target_lines == found[1].target_lines);
    EXPECT_TRUE(found[0].line_weights == found[1].line_weights);
}

TEST(Gcpw_PairMatchesInput, a_cancelled_search_says_so)
{
    const Scene scene(smallScene());
    const PairMatches matches =
        findPairMatches(scene.source(), scene.target(), Params(), [](const std::string&, double) { return false; });
    EXPECT_EQ(matches.status, Status::CANCELLED);
    EXPECT_FALSE(matches.message.empty());
}

TEST(Gcpw_PairMatchesInput, matches_that_do_not_fit_are_refused)
{
    const Scene scene(smallScene());
    const PairMatches good = findPairMatches(scene.source(), scene.target());
    ASSERT_FALSE(good.source_points.empty());
    const auto refused = [&](const PairMatches& bad)
    { EXPECT_THROW(alignPair(scene.source(), scene.target(), bad), cv::Exception); };
    PairMatches bad = good;
    bad.source_size.width += 1;
    refused(bad);
    bad = good;
    bad.target_points.pop_back();
    refused(bad);
    bad = good;
    bad.source_lines.emplace_back(1, 1, 5, 5);
    refused(bad);
    bad.target_lines.emplace_back(1, 1, 1, 1);
    bad.line_weights.push_back(1);
    refused(bad);
    bad.target_lines.back() = Vec4d(1, 1, 5, 5);
    bad.line_weights.back() = 0;
    refused(bad);
}

}} // namespace
