// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#ifndef OPENCV_GCPW_SEEDED_MATCHER_HPP
#define OPENCV_GCPW_SEEDED_MATCHER_HPP

#include <atomic>
#include <functional>
#include <vector>
#include <opencv2/stitching/detail/matchers.hpp>

namespace cv
{
namespace gcpw
{

/** @brief Another features matcher that always draws the same numbers.

OpenCV's matchers look for neighbours in random trees: what they find, and with it the cameras, depends on what the thread has
drawn before. Here each call starts from the state of cv::theRNG() in a new thread, so that two images get what a program that
has drawn nothing gets, and puts the caller's state back. */
class SeededMatcher : public cv::detail::FeaturesMatcher
{
public:
    /// @param on_pair called after each pair of images, from any thread; false leaves out those to come. May be empty. Not called by
    /// matchers that choose the pairs themselves, which OpenCV has since 4.7
    explicit SeededMatcher(const Ptr<cv::detail::FeaturesMatcher>& matcher,
                           const std::function<bool()>& on_pair = std::function<bool()>())
        : cv::detail::FeaturesMatcher(matcher && matcher->isThreadSafe()), matcher_(matcher), on_pair_(on_pair)
    {
    }

    Ptr<cv::detail::FeaturesMatcher> matcher() const { return matcher_; }

    void collectGarbage() override
    {
        if (matcher_)
            matcher_->collectGarbage();
    }

protected:
    void match(const cv::detail::ImageFeatures& a, const cv::detail::ImageFeatures& b, cv::detail::MatchesInfo& found) override
    {
        if (stopped_)
            return;
        {
            const Seed seed;
            real()(a, b, found);
        }
        if (on_pair_ && !on_pair_())
            stopped_ = true;
    }

#if CV_VERSION_MAJOR > 4 || (CV_VERSION_MAJOR == 4 && CV_VERSION_MINOR >= 7)
    // Since OpenCV 4.7 a matcher may choose the pairs by itself.
    void match(const std::vector<cv::detail::ImageFeatures>& features, std::vector<cv::detail::MatchesInfo>& found,
               const UMat& mask) override
    {
        const Seed seed;
        real()(features, found, mask);
    }
#endif

private:
    /// The first state of this thread's generator, as long as it lives.
    class Seed
    {
    public:
        Seed() : before_(theRNG()) { theRNG() = RNG(); }
        ~Seed() { theRNG() = before_; }
        Seed(const Seed&) = delete;
        Seed& operator=(const Seed&) = delete;

    private:
        RNG before_;
    };

    cv::detail::FeaturesMatcher& real()
    {
        if (!matcher_)
            CV_Error(Error::StsNullPtr, "gcpw: the stitcher had no features matcher when attach() was called: call setFeaturesMatcher(), "
                                        "then attach() once more");
        return *matcher_;
    }

    Ptr<cv::detail::FeaturesMatcher> matcher_;
    std::function<bool()> on_pair_;
    std::atomic<bool> stopped_{false};
};

} // namespace gcpw
} // namespace cv

#endif
