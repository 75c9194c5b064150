// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#include "test_precomp.hpp"

namespace opencv_test { namespace {

using namespace cv::gcpw;

std::string complaintOf(const Params& params)
{
    try
    {
        params.check();
    }
    catch (const cv::Exception& error)
    {
        EXPECT_EQ(error.code, Error::StsOutOfRange);
        return error.what();
    }
    return std::string();
}

TEST(Gcpw_Params, defaults_and_the_papers_constants_are_in_range)
{
    EXPECT_EQ(complaintOf(Params()), "");
    EXPECT_EQ(complaintOf(Params::paper()), "");
}

TEST(Gcpw_Params, paper_gives_the_constants_of_the_paper)
{
    const Params p = Params::paper();
    EXPECT_EQ(p.method, Method::GCPW);
    EXPECT_EQ(p.meshCols, 32);
    EXPECT_EQ(p.meshRows, 32);
    EXPECT_EQ(p.photometricWeight, 100);
    EXPECT_EQ(p.geometricWeight, 1);
    EXPECT_EQ(p.similarityWeight, 0.5);
    EXPECT_EQ(p.colorSmoothnessWeight, 1);
    EXPECT_EQ(p.colorRestWeight, 1);
    EXPECT_EQ(p.sampleStep, 3);
    EXPECT_EQ(p.lineStep, 5);
    EXPECT_EQ(p.pyramidLevels, 3);
}

TEST(Gcpw_Params, paper_switches_every_addition_off)
{
    const Params p = Params::paper();
    EXPECT_EQ(p.robustScale, 0);
    EXPECT_EQ(p.matchScale, 0);
    EXPECT_EQ(p.contrastFloor, 0);
    EXPECT_EQ(p.anchorWeight, 0);
    EXPECT_EQ(p.gainSupport, 0);
    EXPECT_EQ(p.exposureWeight, 0);
    EXPECT_EQ(p.balanceWeight, 0);
    EXPECT_EQ(p.restWeight, 0);
    EXPECT_EQ(p.straightnessWeight, 0);
    EXPECT_EQ(p.stretchLimit, 0);
    EXPECT_EQ(p.distortionPrice, 0);
    EXPECT_EQ(p.outsideWeight, 0);
    EXPECT_EQ(p.stopGain, 0) << "the paper ends when the mesh is stable";
    EXPECT_GE(p.maxIterations, 1000) << "and by nothing else";
}

TEST(Gcpw_Params, alignment_only_lets_lines_and_shapes_go)
{
    Params p = Params::alignmentOnly();
    EXPECT_EQ(p.straightnessWeight, 0);
    EXPECT_EQ(p.stretchLimit, 0);
    const Params defaults;
    EXPECT_GT(defaults.straightnessWeight, 0);
    for (const char* const name : {"straightnessWeight", "outsideWeight", "stretchLimit", "similarityWeight", "distortionPrice"})
        p.set(name, defaults.get(name));
    for (const std::string& name : Params::names())
        EXPECT_EQ(p.get(name), defaults.get(name)) << name;
}

TEST(Gcpw_Params, every_member_is_set_and_read_by_its_name)
{
    ASSERT_GT(Params::names().size(), 15u);
    for (const std::string& name : Params::names())
    {
        Params p;
        const double value = p.get(name) + 1;
        p.set(name, value);
        EXPECT_EQ(p.get(name), value) << name;
        for (const std::string& other : Params::names())
        {
            if (other != name)
            {
                EXPECT_EQ(p.get(other), Params().get(other)) << name << " changes " << other;
            }
        }
    }
}

TEST(Gcpw_Params, names_mean_the_members_that_are_called_so)
{
    Params p;
    p.set("similarityWeight", 0.7);
    p.set("meshCols", 12);
    p.set("matchRatio", 0.6);
    EXPECT_EQ(p.similarityWeight, 0.7);
    EXPECT_EQ(p.meshCols, 12);
    EXPECT_EQ(p.matchRatio, 0.6);
}

TEST(Gcpw_Params, a_member_out_of_range_is_named_with_its_value)
{
    for (const std::string& name : Params::names())
    {
        Params p;
        p.set(name, -7);
        EXPECT_NE(complaintOf(p).find("Params::" + name + " is -7"), std::string::npos) << name << complaintOf(p);
    }
}

TEST(Gcpw_Params, not_a_number_is_out_of_range)
{
    for (const std::string& name : Params::names())
    {
        Params p;
        try
        {
            p.set(name, std::numeric_limits<double>::quiet_NaN());
        }
        catch (const cv::Exception&)
        {
            continue; // a whole number
        }
        EXPECT_NE(complaintOf(p).find(name), std::string::npos) << name;
    }
}

TEST(Gcpw_Params, every_member_has_an_upper_bound_and_names_it)
{
    for (const std::string& name : Params::names())
        for (const double value : {std::numeric_limits<double>::infinity(), 1e300, 1e10})
        {
            Params p;
            try
            {
                p.set(name, value);
            }
            catch (const cv::Exception&)
            {
                continue; // a whole number
            }
            EXPECT_NE(complaintOf(p).find(name), std::string::npos) << name;
            EXPECT_NE(complaintOf(p).find("at most"), std::string::npos) << name;
        }
}

TEST(Gcpw_Params, lines_are_not_sampled_without_end)
{
    Params p;
    p.lineStep = 0.1;
    EXPECT_EQ(complaintOf(p), "");
    p.lineStep = 0.0999;
    EXPECT_NE(complaintOf(p).find("lineStep"), std::string::npos);
}

TEST(Gcpw_Params, bounds_that_are_excluded_are_refused)
{
    Params p;
    p.similarityWeight = 0;
    EXPECT_NE(complaintOf(p).find("greater than 0"), std::string::npos);
    p = Params();
    p.photometricWeight = 0;
    EXPECT_EQ(complaintOf(p), "");
    p = Params();
    p.meshRows = 256;
    EXPECT_EQ(complaintOf(p), "");
    p.meshRows = 257;
    EXPECT_NE(complaintOf(p).find("at most 256"), std::string::npos);
}

TEST(Gcpw_Params, a_method_that_does_not_exist_is_refused)
{
    Params p;
    p.method = static_cast<Method>(17);
    EXPECT_NE(complaintOf(p), "");
}

TEST(Gcpw_Params, an_unknown_name_is_answered_with_all_names)
{
    Params p;
    try
    {
        p.set("simlarityWeight", 1);
        FAIL() << "accepted";
    }
    catch (const cv::Exception& error)
    {
        EXPECT_EQ(error.code, Error::StsBadArg);
        for (const std::string& name : Params::names())
            EXPECT_NE(std::string(error.what()).find(name), std::string::npos) << name;
    }
    EXPECT_THROW(p.get(""), cv::Exception);
}

TEST(Gcpw_Params, whole_numbers_refuse_fractions)
{
    Params p;
    EXPECT_THROW(p.set("meshCols", 3.5), cv::Exception);
    EXPECT_EQ(p.meshCols, Params().meshCols);
}

}} // namespace
