// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#include "test_precomp.hpp"

#include <algorithm>
#include <new>
#include <stdexcept>
#include "log.hpp"
#include "refusal.hpp"
#include "stitch_scene.hpp"

namespace opencv_test { namespace {

std::vector<cv::detail::CameraParams> frameCameras()
{
    return {cameraAt(-0.45, -0.03), cameraAt(0), cameraAt(0.45, 0.03)};
}

/// Refuses one allocation when it is told to.
class OutOfMemoryOnce : public MatAllocator
{
public:
    OutOfMemoryOnce() { Mat::setDefaultAllocator(this); }
    ~OutOfMemoryOnce() override { Mat::setDefaultAllocator(Mat::getStdAllocator()); }

    bool armed = false;

    UMatData* allocate(int dims, const int* sizes, int type, void* data, size_t* step, AccessFlag flags,
                       UMatUsageFlags usage) const override
    {
        if (armed)
        {
            const_cast<OutOfMemoryOnce*>(this)->armed = false;
            CV_Error(Error::StsNoMem, "Failed to allocate");
        }
        return Mat::getStdAllocator()->allocate(dims, sizes, type, data, step, flags, usage);
    }
    bool allocate(UMatData* data, AccessFlag flags, UMatUsageFlags usage) const override
    {
        return Mat::getStdAllocator()->allocate(data, flags, usage);
    }
    void deallocate(UMatData* data) const override { Mat::getStdAllocator()->deallocate(data); }
};

/// What an attached stitcher shows that nothing disturbs.
Mat undisturbed()
{
    const Ptr<Stitcher> stitcher = makeStitcher();
    gcpw::attach(stitcher, quick());
    Mat panorama;
    EXPECT_EQ(stitcher->stitch(frameOf(), panorama), Stitcher::OK);
    return panorama;
}

TEST(Gcpw_StitcherBinding, a_cancelled_estimate_is_made_again_for_the_next_panorama)
{
    bool go_on = false;
    const Ptr<Stitcher> stitcher = makeStitcher();
    const Ptr<gcpw::StitcherBinding> binding = gcpw::attach(stitcher, quick(), [&](const std::string&, double) { return go_on; });
    Mat panorama;
    ASSERT_EQ(stitcher->stitch(frameOf(), panorama), Stitcher::OK);
    EXPECT_EQ(binding->rig().alignment.report().status, gcpw::Status::CANCELLED);
    EXPECT_EQ(binding->estimations(), 1) << "one answer for both passes of a panorama";
    // Composed again, from images that were shown before.
    ASSERT_EQ(stitcher->composePanorama(frameOf(), panorama), Stitcher::OK);
    EXPECT_EQ(binding->estimations(), 2);
    EXPECT_EQ(binding->rig().alignment.report().status, gcpw::Status::CANCELLED);
    go_on = true;
    ASSERT_EQ(stitcher->composePanorama(frameOf(), panorama), Stitcher::OK);
    EXPECT_TRUE(binding->rig().usable()) << binding->rig().alignment.report().message;
    EXPECT_EQ(binding->estimations(), 3);
    expectSame(undisturbed(), panorama);
    ASSERT_EQ(stitcher->stitch(frameOf(), panorama), Stitcher::OK);
    EXPECT_EQ(binding->estimations(), 3) << "what is usable is kept";
    expectSame(undisturbed(), panorama);
}

TEST(Gcpw_StitcherBinding, stitching_again_after_cancelling_is_as_if_nothing_had_been)
{
    bool go_on = false;
    const Ptr<Stitcher> stitcher = makeStitcher();
    const Ptr<gcpw::StitcherBinding> binding = gcpw::attach(stitcher, quick(), [&](const std::string&, double) { return go_on; });
    Mat panorama;
    ASSERT_EQ(stitcher->stitch(frameOf(), panorama), Stitcher::OK);
    go_on = true;
    ASSERT_EQ(stitcher->stitch(frameOf(), panorama), Stitcher::OK);
    EXPECT_TRUE(binding->rig().usable());
    expectSame(undisturbed(), panorama);
}

TEST(Gcpw_StitcherBinding, an_estimate_short_of_memory_is_made_again)
{
    const Mat expected = undisturbed();
    OutOfMemoryOnce allocator;
    bool disturb = true;
    const Ptr<Stitcher> stitcher = makeStitcher();
    const Ptr<gcpw::StitcherBinding> binding = gcpw::attach(stitcher, quick(), [&](const std::string& stage, double)
    {
        if (disturb && stage == "align")
        {
            allocator.armed = true;
            disturb = false;
        }
        return true;
    });
    Mat panorama;
    ASSERT_EQ(stitcher->stitch(frameOf(), panorama), Stitcher::OK);
    EXPECT_FALSE(disturb);
    EXPECT_FALSE(binding->rig().usable());
    EXPECT_NE(binding->rig().alignment.report().message.find("memory"), std::string::npos) << binding->rig().alignment.report().message;
    ASSERT_EQ(stitcher->stitch(frameOf(), panorama), Stitcher::OK);
    EXPECT_TRUE(binding->rig().usable()) << binding->rig().alignment.report().message;
    expectSame(expected, panorama);
}

TEST(Gcpw_StitcherBinding, images_of_another_panorama_are_not_taken_after_cancelling)
{
    const Ptr<Stitcher> stitcher = makeStitcher();
    const Ptr<gcpw::StitcherBinding> binding = gcpw::attach(stitcher, quick(), [](const std::string&, double) { return false; });
    Mat panorama;
    ASSERT_EQ(stitcher->stitch(frameOf(), panorama), Stitcher::OK);
    ASSERT_EQ(stitcher->setTransform(frameOf(1), frameCameras()), Stitcher::OK);
    ASSERT_EQ(stitcher->composePanorama(panorama), Stitcher::OK);
    EXPECT_EQ(binding->estimations(), 1);
    EXPECT_NE(binding->rig().alignment.report().message.find("no images"), std::string::npos);
}

/// Throws once, then lets the estimate go on.
template <typename Thrown>
void expectPassesThrough(const Thrown& thrown)
{
    bool calm = false;
    const Ptr<Stitcher> stitcher = makeStitcher();
    const Ptr<gcpw::StitcherBinding> binding = gcpw::attach(stitcher, quick(), [&](const std::string& stage, double)
    {
        if (!calm && stage == "align")
            throw thrown;
        return true;
    });
    ASSERT_EQ(stitcher->estimateTransform(frameOf()), Stitcher::OK);
    Mat panorama;
    EXPECT_THROW(stitcher->composePanorama(panorama), Thrown);
    EXPECT_FALSE(binding->rig().usable());
    EXPECT_FALSE(binding->rig().alignment.report().message.empty());
    calm = true;
    ASSERT_EQ(stitcher->composePanorama(frameOf(), panorama), Stitcher::OK);
    EXPECT_TRUE(binding->rig().usable()) << binding->rig().alignment.report().message;
    EXPECT_EQ(binding->estimations(), 2);
}

TEST(Gcpw_StitcherBinding, what_the_callback_throws_passes_through_and_the_next_panorama_is_estimated)
{
    expectPassesThrough(std::runtime_error("enough"));
    expectPassesThrough(cv::Exception(Error::StsInternal, "enough", "callback", __FILE__, __LINE__));
    expectPassesThrough(std::bad_alloc());
    expectPassesThrough(42);
}

TEST(Gcpw_StitcherBinding, a_warper_replaced_after_attach_is_noticed_and_the_panorama_is_plain)
{
    const Ptr<Stitcher> plain = makeStitcher();
    plain->setWarper(makePtr<cv::CylindricalWarper>());
    const Ptr<Stitcher> stitcher = makeStitcher();
    const Ptr<gcpw::StitcherBinding> binding = gcpw::attach(stitcher, quick());
    EXPECT_TRUE(binding->replacedParts().empty());
    Mat panorama;
    ASSERT_EQ(stitcher->stitch(frameOf(), panorama), Stitcher::OK);
    EXPECT_TRUE(binding->rig().usable());
    const Ptr<WarperCreator> ours = stitcher->warper();
    stitcher->setWarper(makePtr<cv::CylindricalWarper>());
    EXPECT_EQ(binding->replacedParts(), std::vector<std::string>{"warper"});
    const Log log;
    ASSERT_EQ(stitcher->stitch(frameOf(), panorama), Stitcher::OK);
    EXPECT_EQ(log.count("warper was replaced after attach(); call attach() last"), 1);
    EXPECT_FALSE(binding->rig().usable());
    EXPECT_NE(binding->rig().alignment.report().message.find("warper was replaced"), std::string::npos);
    // The old rig's colours would be shown on pictures without its meshes.
    Mat expected;
    ASSERT_EQ(plain->setTransform(frameOf(), stitcher->cameras(), stitcher->component()), Stitcher::OK);
    ASSERT_EQ(plain->composePanorama(expected), Stitcher::OK);
    expectSame(expected, panorama);
    stitcher->setWarper(ours);
    EXPECT_TRUE(binding->replacedParts().empty());
    ASSERT_EQ(stitcher->stitch(frameOf(), panorama), Stitcher::OK);
    EXPECT_TRUE(binding->rig().usable());
}

TEST(Gcpw_StitcherBinding, other_parts_replaced_after_attach_are_noticed)
{
    const Ptr<Stitcher> stitcher = makeStitcher();
    const Ptr<gcpw::StitcherBinding> binding = gcpw::attach(stitcher, quick());
    stitcher->setExposureCompensator(makePtr<cv::detail::GainCompensator>());
    stitcher->setFeaturesFinder(SIFT::create(2000, 3, 0.01));
    stitcher->setFeaturesMatcher(makePtr<cv::detail::BestOf2NearestMatcher>());
    EXPECT_EQ(binding->replacedParts(), (std::vector<std::string>{"exposure compensator", "features finder", "features matcher"}));
    const Log log;
    Mat panorama;
    ASSERT_EQ(stitcher->stitch(frameOf(), panorama), Stitcher::OK);
    for (const std::string part : {"exposure compensator", "features finder", "features matcher"})
        EXPECT_EQ(log.count(part + " was replaced after attach(); call attach() last"), 1) << part;
    EXPECT_NE(binding->rig().alignment.report().message.find("features finder was replaced"), std::string::npos)
        << binding->rig().alignment.report().message;
    const Ptr<gcpw::StitcherBinding> again = gcpw::attach(stitcher, quick());
    EXPECT_TRUE(again->replacedParts().empty());
    EXPECT_EQ(binding->replacedParts().size(), size_t(4));
    ASSERT_EQ(stitcher->stitch(frameOf(), panorama), Stitcher::OK);
    EXPECT_TRUE(again->rig().usable());
}

TEST(Gcpw_StitcherBinding, the_callback_may_attach_again)
{
    const Ptr<Stitcher> stitcher = makeStitcher();
    Ptr<gcpw::StitcherBinding> inner;
    gcpw::attach(stitcher, quick(), [&](const std::string&, double)
    {
        if (!inner)
            inner = gcpw::attach(stitcher, quick());
        return true;
    });
    Mat panorama;
    ASSERT_EQ(stitcher->stitch(frameOf(), panorama), Stitcher::OK);
    ASSERT_TRUE(inner);
    ASSERT_EQ(stitcher->stitch(frameOf(), panorama), Stitcher::OK);
    EXPECT_TRUE(inner->rig().usable()) << inner->rig().alignment.report().message;
    expectSame(undisturbed(), panorama);
}

TEST(Gcpw_StitcherBinding, the_callback_may_replace_the_warper)
{
    const Ptr<Stitcher> stitcher = makeStitcher();
    const Ptr<gcpw::StitcherBinding> binding = gcpw::attach(stitcher, quick(), [&](const std::string&, double)
    {
        stitcher->setWarper(makePtr<cv::SphericalWarper>());
        return true;
    });
    Mat panorama;
    ASSERT_EQ(stitcher->stitch(frameOf(), panorama), Stitcher::OK);
    EXPECT_NE(binding->rig().alignment.report().message.find("warper was replaced"), std::string::npos);
}

TEST(Gcpw_StitcherBinding, a_panorama_of_images_that_nobody_has_shown_is_warned_of_once)
{
    const Ptr<Stitcher> stitcher = makeStitcher();
    const Ptr<gcpw::StitcherBinding> binding = gcpw::attach(stitcher, quick());
    ASSERT_EQ(stitcher->setTransform(frameOf(), frameCameras()), Stitcher::OK);
    Mat panorama;
    for (int panoramas = 1; panoramas <= 2; ++panoramas)
    {
        const Log log;
        ASSERT_EQ(stitcher->composePanorama(frameOf(), panorama), Stitcher::OK);
        EXPECT_EQ(log.count("has shown no images"), 1) << panoramas;
    }
    EXPECT_EQ(binding->rig().cameras.size(), size_t(3));
    EXPECT_EQ(binding->estimations(), 0);
}

TEST(Gcpw_StitcherBinding, a_stitcher_without_finder_or_matcher_says_so)
{
    for (const bool finder : {true, false})
    {
        const Ptr<Stitcher> stitcher = makeStitcher();
        if (finder)
            stitcher->setFeaturesFinder(Ptr<Feature2D>());
        else
            stitcher->setFeaturesMatcher(Ptr<cv::detail::FeaturesMatcher>());
        const Log log;
        const Ptr<gcpw::StitcherBinding> binding = gcpw::attach(stitcher, quick());
        EXPECT_EQ(log.count(finder ? "has no features finder" : "has no features matcher"), 1);
        Mat panorama;
        try
        {
            stitcher->stitch(frameOf(), panorama);
            FAIL() << "there are no features";
        }
        catch (const cv::Exception& e)
        {
            EXPECT_NE(e.err.find(finder ? "setFeaturesFinder()" : "setFeaturesMatcher()"), std::string::npos) << e.err;
        }
        // Neither is needed for cameras that are known.
        binding->setImages(frameOf());
        ASSERT_EQ(stitcher->setTransform(frameOf(), frameCameras()), Stitcher::OK);
        ASSERT_EQ(stitcher->composePanorama(panorama), Stitcher::OK);
        EXPECT_TRUE(binding->rig().usable());
    }
    const Ptr<Stitcher> stitcher = makeStitcher();
    stitcher->setWarper(Ptr<WarperCreator>());
    EXPECT_THROW(gcpw::attach(stitcher), cv::Exception);
}

TEST(Gcpw_StitcherBinding, a_rig_whose_parts_contradict_each_other_is_estimated_anew)
{
    const Ptr<Stitcher> stitcher = makeStitcher();
    const Ptr<gcpw::StitcherBinding> binding = gcpw::attach(stitcher, quick());
    Mat panorama;
    ASSERT_EQ(stitcher->stitch(frameOf(), panorama), Stitcher::OK);
    gcpw::Rig broken = binding->rig();
    broken.turns = {0};
    const Log log;
    expectTaken([&] { binding->setRig(broken); });
    EXPECT_EQ(log.count("turns of a rig has 1 entries"), 1);
    ASSERT_EQ(stitcher->stitch(frameOf(), panorama), Stitcher::OK);
    EXPECT_EQ(binding->estimations(), 2);
    EXPECT_TRUE(binding->rig().usable()) << binding->rig().alignment.report().message;
    expectSame(undisturbed(), panorama);
}

TEST(Gcpw_StitcherBinding, a_refinement_that_fails_throws_nothing_while_a_panorama_is_composed)
{
    // Neither can be brought to the registration's size, nor warped; the stitcher itself has good images.
    for (const int type : {CV_32SC3, CV_16UC4})
    {
        const Ptr<Stitcher> stitcher = makeStitcher();
        stitcher->setRegistrationResol(0.03);
        const Ptr<gcpw::StitcherBinding> binding = gcpw::attach(stitcher, quick());
        binding->setImages(std::vector<Mat>(3, Mat(RIG_IMAGE, type, Scalar::all(9))));
        ASSERT_EQ(stitcher->setTransform(frameOf(), frameCameras()), Stitcher::OK);
        Mat panorama;
        EXPECT_NO_THROW(stitcher->composePanorama(panorama));
        EXPECT_FALSE(panorama.empty());
        EXPECT_FALSE(binding->rig().usable());
        EXPECT_FALSE(binding->rig().alignment.report().message.empty());
    }
}

}} // namespace
