// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#include "test_precomp.hpp"

#include "stitch_scene.hpp"

namespace opencv_test { namespace {

TEST(Gcpw_SeededMatcher, the_same_images_give_the_same_bits_whatever_was_drawn_before)
{
    const RNG before = theRNG();
    Mat panoramas[3];
    const Ptr<Stitcher> stitcher = makeStitcher();
    for (int k = 0; k < 2; ++k)
    {
        theRNG() = RNG(k == 0 ? 1 : 987654321);
        const Ptr<gcpw::StitcherBinding> binding = gcpw::attach(stitcher, quick());
        ASSERT_EQ(stitcher->stitch(frameOf(), panoramas[k]), Stitcher::OK);
        EXPECT_TRUE(binding->rig().usable());
    }
    ASSERT_EQ(stitcher->stitch(frameOf(), panoramas[2]), Stitcher::OK);
    theRNG() = before;
    expectSame(panoramas[0], panoramas[1]);
    expectSame(panoramas[0], panoramas[2]);
}

/// Draws a number for each pair, and remembers it.
class Drawing : public cv::detail::FeaturesMatcher
{
public:
    std::vector<unsigned> drawn;

protected:
    void match(const cv::detail::ImageFeatures&, const cv::detail::ImageFeatures&, cv::detail::MatchesInfo&) override
    {
        drawn.push_back(theRNG().next());
    }
};

TEST(Gcpw_SeededMatcher, a_matcher_draws_from_a_fixed_state_and_the_threads_state_is_put_back)
{
    const Ptr<Stitcher> stitcher = makeStitcher();
    const Ptr<Drawing> drawing = makePtr<Drawing>();
    stitcher->setFeaturesMatcher(drawing);
    for (int k = 0; k < 2; ++k)
    {
        gcpw::attach(stitcher, quick()); // twice: the second unwraps the first
        const Ptr<cv::detail::FeaturesMatcher> matcher = stitcher->featuresMatcher();
        EXPECT_EQ(matcher->isThreadSafe(), drawing->isThreadSafe());
        const RNG before = theRNG();
        theRNG() = RNG(5 + k);
        cv::detail::MatchesInfo found;
        (*matcher)(cv::detail::ImageFeatures(), cv::detail::ImageFeatures(), found);
        EXPECT_EQ(theRNG().state, RNG(5 + k).state);
        theRNG() = before;
    }
    ASSERT_EQ(drawing->drawn.size(), size_t(2));
    EXPECT_EQ(drawing->drawn[0], drawing->drawn[1]);
    EXPECT_EQ(drawing->drawn[0], RNG().next()) << "what a new thread draws first";
}

TEST(Gcpw_SeededMatcher, two_images_have_the_cameras_of_a_plain_stitcher_in_a_new_thread)
{
    std::vector<cv::detail::CameraParams> cameras[2];
    std::vector<Mat> images = frameOf();
    images.resize(2);
    for (int k = 0; k < 2; ++k)
    {
        const RNG before = theRNG();
        theRNG() = k == 0 ? RNG() : RNG(3);
        const Ptr<Stitcher> stitcher = makeStitcher();
        if (k == 1)
            gcpw::attach(stitcher, quick());
        EXPECT_EQ(stitcher->estimateTransform(images), Stitcher::OK);
        cameras[k] = stitcher->cameras();
        theRNG() = before;
    }
    ASSERT_EQ(cameras[0].size(), size_t(2));
    gcpw::Rig rig;
    rig.cameras = cameras[0];
    EXPECT_TRUE(rig.fits(cameras[1]));
}

}} // namespace
