// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#include "opencv2/gcpw/stitcher.hpp"

#include <opencv2/core/utils/logger.hpp>
#include "stitching/part_factory.hpp"
#include "stitching/seeded_matcher.hpp"
#include "stitching/stitcher_binding.hpp"

namespace cv
{
namespace gcpw
{

namespace
{

/// A stitcher's own part, also where an earlier attach() has wrapped it.
Ptr<WarperCreator> plainWarper(const Ptr<Stitcher>& stitcher)
{
    const Ptr<GcpwWarper> wrapped = stitcher->warper().dynamicCast<GcpwWarper>();
    return wrapped ? wrapped->base() : stitcher->warper();
}

Ptr<cv::detail::ExposureCompensator> plainCompensator(const Ptr<Stitcher>& stitcher)
{
    const Ptr<GcpwCompensator> wrapped = stitcher->exposureCompensator().dynamicCast<GcpwCompensator>();
    return wrapped ? wrapped->fallback() : stitcher->exposureCompensator();
}

Ptr<Feature2D> plainFinder(const Ptr<Stitcher>& stitcher)
{
    const Ptr<ImageCapture> wrapped = stitcher->featuresFinder().dynamicCast<ImageCapture>();
    return wrapped ? wrapped->finder() : stitcher->featuresFinder();
}

Ptr<cv::detail::FeaturesMatcher> plainMatcher(const Ptr<Stitcher>& stitcher)
{
    const Ptr<SeededMatcher> wrapped = stitcher->featuresMatcher().dynamicCast<SeededMatcher>();
    return wrapped ? wrapped->matcher() : stitcher->featuresMatcher();
}

Ptr<cv::detail::SeamFinder> plainSeamFinder(const Ptr<Stitcher>& stitcher)
{
    const Ptr<GcpwSeamFinder> wrapped = stitcher->seamFinder().dynamicCast<GcpwSeamFinder>();
    return wrapped && wrapped->fallback() ? wrapped->fallback() : stitcher->seamFinder();
}

} // namespace

Ptr<StitcherBinding> attach(const Ptr<Stitcher>& stitcher, const Params& params)
{
    return attach(stitcher, params, Progress());
}

Ptr<StitcherBinding> attach(const Ptr<Stitcher>& stitcher, const Params& params, const Progress& progress)
{
    if (!stitcher)
        CV_Error(Error::StsNullPtr, "gcpw: attach() needs a stitcher");
    params.check();
    const Ptr<WarperCreator> base = plainWarper(stitcher);
    if (!base)
        CV_Error(Error::StsNullPtr, "gcpw: attach() needs a stitcher with a warper: call setWarper() before");
    const Ptr<Feature2D> finder = plainFinder(stitcher);
    const Ptr<cv::detail::FeaturesMatcher> matcher = plainMatcher(stitcher);
    if (!finder || !matcher)
        CV_LOG_WARNING(nullptr, "gcpw: the stitcher has no features " << (finder ? "matcher" : "finder")
                                << ": it can compose after setTransform(), but not stitch()");
    const Ptr<Binding> binding = makePtr<Binding>(stitcher, params, progress);
    binding->shared_state()->base = base;
    // The shared state is part of the binding: a strong reference here would never be released.
    const std::weak_ptr<Binding> weak = binding;
    const auto hook = [weak](void (Binding::*call)())
    {
        return [weak, call]
        {
            if (const Ptr<Binding> alive = weak.lock())
                (alive.get()->*call)();
        };
    };
    binding->shared_state()->before_create = hook(&Binding::beforeCreate);
    binding->shared_state()->before_feed = hook(&Binding::atWork);
    // The warper keeps the binding alive for callers who drop it.
    const std::shared_ptr<SharedState> shared_state(binding, binding->shared_state().get());
    stitcher->setWarper(PartFactory::warper(shared_state));
    const Ptr<GcpwCompensator> compensator = PartFactory::compensator(params, shared_state);
    compensator->setFallback(plainCompensator(stitcher));
    stitcher->setExposureCompensator(compensator);
    stitcher->setFeaturesFinder(makePtr<ImageCapture>(finder, binding->shown(), hook(&Binding::atWork)));
    stitcher->setFeaturesMatcher(makePtr<SeededMatcher>(matcher));
    const Ptr<cv::detail::SeamFinder> seam_finder = plainSeamFinder(stitcher);
    if (seam_finder.dynamicCast<cv::detail::GraphCutSeamFinder>()) // the default; any other was chosen
        stitcher->setSeamFinder(PartFactory::seamFinder(shared_state, seam_finder));
    binding->installed();
    return binding;
}

std::string explain(Stitcher::Status status)
{
    const std::string alone = "leave out photographs that do not belong to the others";
    switch (status)
    {
    case Stitcher::OK:
        return "stitched";
    case Stitcher::ERR_NEED_MORE_IMGS:
        return "no two of the photographs match; let a third of each overlap";
    case Stitcher::ERR_HOMOGRAPHY_EST_FAIL:
        return "no cameras fit the matches; " + alone;
    case Stitcher::ERR_CAMERA_PARAMS_ADJUST_FAIL:
        return "the cameras could not be adjusted to the matches; " + alone;
    }
    return "unknown status";
}

} // namespace gcpw
} // namespace cv
