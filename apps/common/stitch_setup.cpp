// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#include "common/stitch_setup.hpp"

#include <algorithm>
#include <functional>
#include <opencv2/stitching/detail/matchers.hpp>
#include <opencv2/stitching/detail/motion_estimators.hpp>
#include <opencv2/stitching/detail/seam_finders.hpp>
#include <opencv2/stitching/detail/warpers.hpp>
#include <utility>
#include <vector>
#include "common/program.hpp"
#include "common/tiled_blender.hpp"

namespace
{

namespace detail = cv::detail;

template <typename T>
using Choices = std::vector<std::pair<std::string, std::function<cv::Ptr<T>()>>>;

/// The choice of this name. Throws WrongUse that lists them.
template <typename T>
cv::Ptr<T> choose(const std::string& what, const std::string& name, const Choices<T>& choices)
{
    std::string known;
    for (const auto& choice : choices)
    {
        if (choice.first == name)
            return choice.second();
        known += (known.empty() ? "" : ", ") + choice.first;
    }
    throw WrongUse("unknown " + what + " '" + name + "'; there are " + known);
}

template <typename T, typename Made>
std::function<cv::Ptr<T>()> make()
{
    return [] { return cv::Ptr<T>(cv::makePtr<Made>()); };
}

cv::Ptr<cv::Feature2D> finderOf(const std::string& name)
{
    // Faint and dark photographs are dropped for want of keypoints at OpenCV's default contrast threshold, 0.04.
    const int most = 4000;
    const double contrast = 0.007;
    return choose<cv::Feature2D>("features", name,
                                 {{"sift", [=] { return cv::Ptr<cv::Feature2D>(cv::SIFT::create(most, 3, contrast)); }},
#if CV_VERSION_MAJOR < 5 // there AKAZE is in contrib's xfeatures2d
                                  {"akaze", [] { return cv::Ptr<cv::Feature2D>(cv::AKAZE::create()); }},
#endif
                                  {"orb", [=] { return cv::Ptr<cv::Feature2D>(cv::ORB::create(most)); }}});
}

cv::Ptr<cv::WarperCreator> warperOf(const std::string& name)
{
    typedef cv::WarperCreator W;
    return choose<W>("warp", name,
                     {{"spherical", make<W, cv::SphericalWarper>()},
                      {"cylindrical", make<W, cv::CylindricalWarper>()},
                      {"plane", make<W, cv::PlaneWarper>()},
                      {"affine", make<W, cv::AffineWarper>()},
                      {"fisheye", make<W, cv::FisheyeWarper>()},
                      {"stereographic", make<W, cv::StereographicWarper>()},
                      {"mercator", make<W, cv::MercatorWarper>()},
                      {"transverseMercator", make<W, cv::TransverseMercatorWarper>()},
                      {"compressedPlaneA2B1", [] { return cv::Ptr<W>(cv::makePtr<cv::CompressedRectilinearWarper>(2.0F, 1.0F)); }},
                      {"compressedPlaneA1.5B1", [] { return cv::Ptr<W>(cv::makePtr<cv::CompressedRectilinearWarper>(1.5F, 1.0F)); }},
                      {"paniniA2B1", [] { return cv::Ptr<W>(cv::makePtr<cv::PaniniWarper>(2.0F, 1.0F)); }},
                      {"paniniA1.5B1", [] { return cv::Ptr<W>(cv::makePtr<cv::PaniniWarper>(1.5F, 1.0F)); }}});
}

cv::Ptr<detail::SeamFinder> seamOf(const std::string& name)
{
    typedef detail::SeamFinder S;
    typedef detail::GraphCutSeamFinder Cut;
    typedef detail::DpSeamFinder Dp;
    return choose<S>("seam", name,
                     {{"no", make<S, detail::NoSeamFinder>()},
                      {"voronoi", make<S, detail::VoronoiSeamFinder>()},
                      {"gc_color", [] { return cv::Ptr<S>(cv::makePtr<Cut>(detail::GraphCutSeamFinderBase::COST_COLOR)); }},
                      {"gc_colorgrad", [] { return cv::Ptr<S>(cv::makePtr<Cut>(detail::GraphCutSeamFinderBase::COST_COLOR_GRAD)); }},
                      {"dp_color", [] { return cv::Ptr<S>(cv::makePtr<Dp>(Dp::COLOR)); }},
                      {"dp_colorgrad", [] { return cv::Ptr<S>(cv::makePtr<Dp>(Dp::COLOR_GRAD)); }}});
}

cv::Ptr<detail::Blender> blenderOf(const std::string& name)
{
    typedef detail::Blender B;
    return choose<B>("blend", name,
                     {{"no", [] { return B::createDefault(B::NO); }},
                      {"feather", [] { return B::createDefault(B::FEATHER); }},
                      {"multiband", make<B, TiledBlender>()}});
}

cv::Ptr<detail::ExposureCompensator> compensatorOf(const std::string& name)
{
    typedef detail::ExposureCompensator E;
    const auto kind = [](int type) { return [type] { return E::createDefault(type); }; };
    return choose<E>("expos_comp", name,
                     {{"no", kind(E::NO)},
                      {"gain", kind(E::GAIN)},
                      {"gain_blocks", kind(E::GAIN_BLOCKS)},
                      {"channels", kind(E::CHANNELS)},
                      {"channels_blocks", kind(E::CHANNELS_BLOCKS)}});
}

cv::Ptr<detail::BundleAdjusterBase> adjusterOf(const std::string& name)
{
    typedef detail::BundleAdjusterBase A;
    return choose<A>("ba", name,
                     {{"ray", make<A, detail::BundleAdjusterRay>()},
                      {"reproj", make<A, detail::BundleAdjusterReproj>()},
                      {"affine", make<A, detail::BundleAdjusterAffinePartial>()},
                      {"no", make<A, detail::NoBundleAdjuster>()}});
}

/// OpenCV's approximate matching draws from the thread's generator: seeded for each pair, cameras are the same in every run.
template <typename Matcher>
class Repeatable : public Matcher
{
public:
    using Matcher::Matcher;

protected:
    void match(const detail::ImageFeatures& a, const detail::ImageFeatures& b, detail::MatchesInfo& info) override
    {
        cv::theRNG() = cv::RNG(static_cast<uint64_t>(a.img_idx * 65536 + b.img_idx + 1));
        Matcher::match(a, b, info);
    }
};

cv::Ptr<detail::FeaturesMatcher> matcherOf(const StitchSetup& setup, float confidence)
{
    if (setup.mode == "scans")
        return cv::makePtr<Repeatable<detail::AffineBestOf2NearestMatcher>>(false, false, confidence);
    if (setup.range_width > 0)
        return cv::makePtr<Repeatable<detail::BestOf2NearestRangeMatcher>>(setup.range_width, false, confidence);
    return cv::makePtr<Repeatable<detail::BestOf2NearestMatcher>>(false, confidence);
}

void setCameraSearch(const StitchSetup& setup, cv::Stitcher& stitcher)
{
    stitcher.setBundleAdjuster(adjusterOf(setup.ba.empty() ? "ray" : setup.ba));
    stitcher.setWaveCorrection(setup.wave_correct != "no");
    stitcher.setWaveCorrectKind(setup.wave_correct == "vert" ? detail::WAVE_CORRECT_VERT : detail::WAVE_CORRECT_HORIZ);
}

} // namespace

void checkSetup(const StitchSetup& setup)
{
    if (setup.mode != "auto" && setup.mode != "panorama" && setup.mode != "scans")
        throw WrongUse("unknown mode '" + setup.mode + "'; there are auto, panorama, scans");
    const std::string& kind = setup.wave_correct;
    if (!kind.empty() && kind != "no" && kind != "horiz" && kind != "vert")
        throw WrongUse("unknown wave_correct '" + kind + "'; there are no, horiz, vert");
    if (!setup.ba.empty())
        adjusterOf(setup.ba);
    if (setup.mode == "auto" && (!setup.ba.empty() || !kind.empty()))
        throw WrongUse("--mode=auto chooses bundle adjustment and wave correction itself; --ba and --wave_correct are for --mode=panorama");
}

cv::gcpw::CameraOptions cameraOptions(const StitchSetup& setup)
{
    // Of matches that only looking at both pictures confirms: the usual ratio of the nearest to the second nearest, 0.75.
    const float loose = 0.25F;
    cv::gcpw::CameraOptions options;
    options.workMegapix = setup.work_megapix;
    options.confidence = setup.conf_thresh;
    options.projection = setup.warp;
    options.finder = finderOf(setup.features);
    options.matcher = matcherOf(setup, static_cast<float>(setup.match_conf));
    options.secondMatcher = matcherOf(setup, std::min(loose, static_cast<float>(setup.match_conf)));
    return options;
}

cv::Ptr<cv::Stitcher> makeStitcher(const StitchSetup& setup)
{
    checkSetup(setup);
    const bool scans = setup.mode == "scans";
    const cv::Ptr<cv::Stitcher> stitcher = cv::Stitcher::create(scans ? cv::Stitcher::SCANS : cv::Stitcher::PANORAMA);
    stitcher->setRegistrationResol(setup.work_megapix);
    stitcher->setSeamEstimationResol(setup.seam_megapix);
    stitcher->setCompositingResol(setup.compose_megapix > 0 ? setup.compose_megapix : cv::Stitcher::ORIG_RESOL);
    stitcher->setPanoConfidenceThresh(setup.conf_thresh);
    stitcher->setFeaturesFinder(finderOf(setup.features));
    stitcher->setFeaturesMatcher(matcherOf(setup, static_cast<float>(setup.match_conf)));
    stitcher->setWarper(warperOf(!setup.warp.empty() ? setup.warp : scans ? "affine" : "spherical"));
    stitcher->setSeamFinder(seamOf(setup.seam));
    stitcher->setBlender(blenderOf(setup.blend));
    stitcher->setExposureCompensator(compensatorOf(scans ? "no" : setup.expos_comp));
    if (!scans)
        setCameraSearch(setup, *stitcher);
    return stitcher;
}

std::string explain(cv::Stitcher::Status status)
{
    switch (status)
    {
    case cv::Stitcher::OK:
        return "stitched";
    case cv::Stitcher::ERR_NEED_MORE_IMGS:
        return "no two of the images match";
    case cv::Stitcher::ERR_HOMOGRAPHY_EST_FAIL:
        return "no cameras fit the matches";
    case cv::Stitcher::ERR_CAMERA_PARAMS_ADJUST_FAIL:
        return "the cameras could not be adjusted to the matches";
    }
    return "unknown status";
}
