// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#include <gtest/gtest.h>
#include <opencv2/imgproc.hpp>
#include "common/synthetic_pair.hpp"
#include "evaluation/color_variation.hpp"
#include "evaluation/methods.hpp"

namespace
{

using evaluation::PairMethod;
using namespace cv::gcpw;

/// The synthetic pair and its matches, found once.
struct Pair
{
    cv::Mat source;
    cv::Mat target;
    PairMatches matches;

    Pair()
    {
        makeSyntheticPair(source, target);
        cv::resize(source, source, cv::Size(), 0.5, 0.5, cv::INTER_AREA);
        cv::resize(target, target, cv::Size(), 0.5, 0.5, cv::INTER_AREA);
        matches = findPairMatches(source, target);
    }

    Alignment by(const PairMethod& method) const { return method.align(source, target, matches, Params(), Progress()); }
    double zncc(const Alignment& alignment) const { return scorePair(renderPair(alignment, source, target)).zncc; }
};

TEST(Evaluation_Methods, names_are_found_and_others_are_not)
{
    for (const PairMethod& method : evaluation::pairMethods())
        EXPECT_EQ(evaluation::findPairMethod(method.name), &method);
    EXPECT_EQ(evaluation::findPairMethod("sift"), nullptr);
    EXPECT_EQ(evaluation::findPairMethod(""), nullptr);
    EXPECT_EQ(evaluation::pairMethodNames(), "global, apap, cpw, dfw, mfw, lsh_mfw, ros_mfw, gcpw");
}

TEST(Evaluation_Methods, each_one_improves_on_the_global_homography)
{
    const Pair pair;
    ASSERT_EQ(pair.matches.status, Status::OK);
    const double global = pair.zncc(pair.by(*evaluation::findPairMethod("global")));
    for (const PairMethod& method : evaluation::pairMethods())
    {
        if (std::string(method.name) != "global")
        {
            EXPECT_LT(pair.zncc(pair.by(method)), global) << method.name;
        }
    }
}

TEST(Evaluation_Methods, the_same_input_gives_the_same_bits)
{
    const Pair pair;
    for (const PairMethod& method : evaluation::pairMethods())
        EXPECT_EQ(cv::norm(pair.by(method).image(0).mesh, pair.by(method).image(0).mesh, cv::NORM_INF), 0) << method.name;
}

TEST(Evaluation_Methods, those_that_do_not_look_at_pixels_do_not_notice_other_colours)
{
    const Pair pair;
    const cv::Mat recolored = evaluation::varyColors(pair.source, 16);
    Params params;
    params.anchorWeight = 0; // pixels have the last word over matches, which are nearly perfect here
    for (const PairMethod& method : evaluation::pairMethods())
    {
        const Alignment before = method.align(pair.source, pair.target, pair.matches, params, Progress());
        const Alignment changed = method.align(recolored, pair.target, pair.matches, params, Progress());
        const double distance = cv::norm(changed.image(0).mesh, before.image(0).mesh, cv::NORM_INF);
        EXPECT_EQ(distance == 0, !method.looks_at_pixels) << method.name;
    }
}

TEST(Evaluation_Methods, deep_gray_and_masked_photographs_are_taken)
{
    const Pair pair;
    cv::Mat deep;
    pair.source.convertTo(deep, CV_16U, 257);
    cv::Mat masked;
    cv::cvtColor(pair.source, masked, cv::COLOR_BGR2BGRA);
    cv::Mat gray;
    cv::cvtColor(pair.source, gray, cv::COLOR_BGR2GRAY);
    for (const PairMethod& method : evaluation::pairMethods())
        for (const cv::Mat& source : {deep, masked, gray})
            EXPECT_TRUE(method.align(source, pair.target, pair.matches, Params(), Progress()).ok()) << method.name;
}

TEST(Evaluation_Methods, photographs_that_do_not_match_have_no_alignment_by_any)
{
    Pair pair;
    pair.matches.status = Status::NO_ALIGNMENT;
    for (const PairMethod& method : evaluation::pairMethods())
        EXPECT_EQ(pair.by(method).report().status, Status::NO_ALIGNMENT) << method.name;
}

} // namespace
