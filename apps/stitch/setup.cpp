// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#include "stitch/setup.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <utility>
#include <opencv2/opencv_modules.hpp>
#include <opencv2/stitching/detail/matchers.hpp>
#include <opencv2/stitching/detail/motion_estimators.hpp>
#include <opencv2/stitching/detail/seam_finders.hpp>
#include <opencv2/stitching/detail/warpers.hpp>
#ifdef HAVE_OPENCV_XFEATURES2D
#include <opencv2/xfeatures2d/nonfree.hpp>
#endif
#include <opencv2/gcpw/seam_finder.hpp>
#include "common/exit_code.hpp"
#include "common/spelling.hpp"
#include "common/tiled_blender.hpp"
#include "stitch/counted_seams.hpp"

namespace
{

namespace detail = cv::detail;

const char* const OWN_SEAM = "gcpw"; ///< --seam of cv::gcpw::GcpwSeamFinder

template <typename T>
using Choices = std::vector<std::pair<std::string, std::function<cv::Ptr<T>()>>>;

template <typename T>
std::vector<std::string> namesOf(const Choices<T>& choices)
{
    std::vector<std::string> names;
    for (const auto& choice : choices)
        names.push_back(choice.first);
    return names;
}

/// The choice of this name. Throws WrongUse that lists them.
template <typename T>
cv::Ptr<T> choose(const std::string& what, const std::string& name, const Choices<T>& choices)
{
    for (const auto& choice : choices)
        if (choice.first == name)
            return choice.second();
    throw WrongUse("there is no --" + what + " '" + name + "'; choose " + listed(namesOf<T>(choices)));
}

template <typename T, typename Made>
std::function<cv::Ptr<T>()> make()
{
    return [] { return cv::Ptr<T>(cv::makePtr<Made>()); };
}

/// Warpers with two ratios, A and B; B is 1.
template <typename Made>
std::function<cv::Ptr<cv::WarperCreator>()> stretched(float a)
{
    return [a] { return cv::Ptr<cv::WarperCreator>(cv::makePtr<Made>(a, 1.0F)); };
}

cv::Ptr<cv::Feature2D> makeSurf()
{
#ifdef HAVE_OPENCV_XFEATURES2D
    try
    {
        return cv::xfeatures2d::SURF::create();
    }
    catch (const cv::Exception&) // built without what is not free
    {
    }
#endif
    throw WrongUse("--features=surf: this OpenCV was built without SURF; choose sift, which finds much the same");
}

const Choices<cv::Feature2D>& finders()
{
    // Faint and dark photographs are dropped for want of keypoints at OpenCV's default contrast threshold, 0.04.
    static const int most = 4000;
    static const double contrast = 0.007;
    static const Choices<cv::Feature2D> choices = {
        {"sift", [] { return cv::Ptr<cv::Feature2D>(cv::SIFT::create(most, 3, contrast)); }},
#if CV_VERSION_MAJOR < 5 // there AKAZE is in contrib's xfeatures2d
        {"akaze", [] { return cv::Ptr<cv::Feature2D>(cv::AKAZE::create()); }},
#endif
        {"orb", [] { return cv::Ptr<cv::Feature2D>(cv::ORB::create(most)); }},
        {"surf", makeSurf}
    };
    return choices;
}

const Choices<cv::WarperCreator>& warpers()
{
    typedef cv::WarperCreator W;
    static const Choices<W> choices = {
        {"spherical", make<W, cv::SphericalWarper>()},
        {"cylindrical", make<W, cv::CylindricalWarper>()},
        {"plane", make<W, cv::PlaneWarper>()},
        {"affine", make<W, cv::AffineWarper>()},
        {"fisheye", make<W, cv::FisheyeWarper>()},
        {"stereographic", make<W, cv::StereographicWarper>()},
        {"compressedPlaneA2B1", stretched<cv::CompressedRectilinearWarper>(2.0F)},
        {"compressedPlaneA1.5B1", stretched<cv::CompressedRectilinearWarper>(1.5F)},
        {"compressedPlanePortraitA2B1", stretched<cv::CompressedRectilinearPortraitWarper>(2.0F)},
        {"compressedPlanePortraitA1.5B1", stretched<cv::CompressedRectilinearPortraitWarper>(1.5F)},
        {"paniniA2B1", stretched<cv::PaniniWarper>(2.0F)},
        {"paniniA1.5B1", stretched<cv::PaniniWarper>(1.5F)},
        {"paniniPortraitA2B1", stretched<cv::PaniniPortraitWarper>(2.0F)},
        {"paniniPortraitA1.5B1", stretched<cv::PaniniPortraitWarper>(1.5F)},
        {"mercator", make<W, cv::MercatorWarper>()},
        {"transverseMercator", make<W, cv::TransverseMercatorWarper>()}};
    return choices;
}

const Choices<detail::SeamFinder>& seams()
{
    typedef detail::SeamFinder S;
    typedef detail::GraphCutSeamFinder Cut;
    typedef detail::DpSeamFinder Dp;
    static const Choices<S> choices = {
        {OWN_SEAM, make<S, cv::gcpw::GcpwSeamFinder>()},
        {"no", make<S, detail::NoSeamFinder>()},
        {"voronoi", make<S, detail::VoronoiSeamFinder>()},
        {"gc_color", [] { return cv::Ptr<S>(cv::makePtr<Cut>(detail::GraphCutSeamFinderBase::COST_COLOR)); }},
        {"gc_colorgrad", [] { return cv::Ptr<S>(cv::makePtr<Cut>(detail::GraphCutSeamFinderBase::COST_COLOR_GRAD)); }},
        {"dp_color", [] { return cv::Ptr<S>(cv::makePtr<Dp>(Dp::COLOR)); }},
        {"dp_colorgrad", [] { return cv::Ptr<S>(cv::makePtr<Dp>(Dp::COLOR_GRAD)); }}};
    return choices;
}

cv::Ptr<detail::BundleAdjusterBase> adjusterOf(const StitchSetup& setup, const std::string& name)
{
    typedef detail::BundleAdjusterBase A;
    const Choices<A> choices = {{"ray", make<A, detail::BundleAdjusterRay>()},
                                {"reproj", make<A, detail::BundleAdjusterReproj>()},
                                {"affine", make<A, detail::BundleAdjusterAffinePartial>()},
                                {"no", make<A, detail::NoBundleAdjuster>()}};
    const cv::Ptr<A> adjuster = choose<A>("ba", name, choices);
    // fx, skew, ppx; aspect, ppy: where stitching_detailed puts them.
    const cv::Point places[] = {{0, 0}, {1, 0}, {2, 0}, {1, 1}, {2, 1}};
    cv::Mat mask = cv::Mat::zeros(3, 3, CV_8U);
    for (size_t i = 0; i < setup.ba_refine_mask.size(); ++i)
        mask.at<uchar>(places[i]) = setup.ba_refine_mask[i] == 'x' ? 1 : 0;
    adjuster->setRefinementMask(mask);
    return adjuster;
}

/// OpenCV's approximate matching draws from the thread's generator: seeded for each pair, cameras are the same in every run.
template <typename Matcher>
class Repeatable : public Matcher
{
public:
    template <typename... Arguments>
    explicit Repeatable(MatchLog* log, Arguments... arguments) : Matcher(arguments...), log_(log)
    {
    }

protected:
    void match(const detail::ImageFeatures& a, const detail::ImageFeatures& b, detail::MatchesInfo& info) override
    {
        cv::theRNG() = cv::RNG(static_cast<uint64_t>(a.img_idx * 65536 + b.img_idx + 1));
        Matcher::match(a, b, info);
        log_->add(a.img_idx, b.img_idx, info);
    }

private:
    MatchLog* log_;
};

cv::Ptr<detail::FeaturesMatcher> matcherOf(const StitchSetup& setup, double confidence, MatchLog& log)
{
    const auto conf = static_cast<float>(confidence);
    if (setup.matcher == "affine" || (setup.matcher.empty() && setup.mode == "scans"))
        return cv::makePtr<Repeatable<detail::AffineBestOf2NearestMatcher>>(&log, false, false, conf);
    if (setup.range_width > 0)
        return cv::makePtr<Repeatable<detail::BestOf2NearestRangeMatcher>>(&log, setup.range_width, false, conf);
    return cv::makePtr<Repeatable<detail::BestOf2NearestMatcher>>(&log, false, conf);
}

double matchConfidence(const StitchSetup& setup)
{
    const double binary = 0.3; // of ORB, whose distances differ less
    const double usual = 0.65;
    return setup.match_conf >= 0 ? setup.match_conf : setup.features == "orb" ? binary : usual;
}

/// "ray", or what was asked for.
std::string orElse(const std::string& asked, const char* otherwise)
{
    return asked.empty() ? otherwise : asked;
}

} // namespace

std::vector<std::string> warpNames()
{
    return namesOf<cv::WarperCreator>(warpers());
}

std::vector<std::string> featureNames()
{
    return namesOf<cv::Feature2D>(finders());
}

std::vector<std::string> seamNames()
{
    return namesOf<detail::SeamFinder>(seams());
}

std::vector<std::string> compensatorNames()
{
    return {"no", "gain", "gain_blocks", "channels", "channels_blocks"};
}

void checkSetup(const StitchSetup& setup)
{
    if (setup.features == "surf")
        makeSurf();
    const std::string& mask = setup.ba_refine_mask;
    if (mask.size() != 5 || mask.find_first_not_of("x_") != std::string::npos)
        throw WrongUse("--ba_refine_mask is five letters, x to refine and _ to keep fx, skew, ppx, aspect and ppy: "
                       "'x_xxx'; got '" +
                       mask + "'");
    const bool by_name = !setup.ba.empty() || !setup.wave_correct.empty() || !setup.matcher.empty() ||
                         !setup.estimator.empty() || mask != StitchSetup().ba_refine_mask;
    if (setup.mode == "auto" && by_name)
        throw WrongUse("--mode=auto chooses cameras itself; --matcher, --estimator, --ba, --ba_refine_mask and "
                       "--wave_correct are for "
                       "--mode=panorama and --mode=scans");
}

cv::Ptr<cv::WarperCreator> warperOf(const std::string& name)
{
    return choose<cv::WarperCreator>("warp", name, warpers());
}

cv::gcpw::CameraOptions cameraOptions(const StitchSetup& setup, MatchLog& log)
{
    // Of matches that only looking at both pictures confirms: the usual ratio of the nearest to the second nearest, 0.75.
    const double loose = 0.25;
    cv::gcpw::CameraOptions options;
    options.workMegapix = setup.work_megapix;
    options.confidence = setup.conf_thresh;
    options.projection = setup.warp;
    options.finder = choose<cv::Feature2D>("features", setup.features, finders());
    options.matcher = matcherOf(setup, matchConfidence(setup), log);
    options.secondMatcher = matcherOf(setup, std::min(loose, matchConfidence(setup)), log);
    return options;
}

Blending blendingOf(const StitchSetup& setup, double area)
{
    // As stitching_detailed: the strength is the width of what is blended, in percent of a side of the picture.
    const double width = std::sqrt(area) * setup.blend_strength / 100;
    const bool by_strength = setup.blend_strength >= 0;
    Blending blending;
    if (setup.blend == "no" || (by_strength && width < 1))
        return blending;
    if (setup.blend == "feather")
    {
        blending.kind = Blending::FEATHER;
        blending.sharpness = by_strength ? static_cast<float>(1 / width) : detail::FeatherBlender().sharpness();
        return blending;
    }
    blending.kind = Blending::BANDS;
    blending.bands = by_strength ? std::max(1, cvCeil(std::log2(width) - 1)) : TiledBlender::USUAL_BANDS;
    return blending;
}

cv::Ptr<detail::Blender> blenderOf(const Blending& blending)
{
    if (blending.kind == Blending::NONE)
        return detail::Blender::createDefault(detail::Blender::NO);
    if (blending.kind == Blending::FEATHER)
        return cv::makePtr<detail::FeatherBlender>(blending.sharpness);
    return cv::makePtr<detail::MultiBandBlender>(0, blending.bands);
}

cv::Ptr<detail::Blender> blenderOf(const StitchSetup& setup, double area, bool deep)
{
    const Blending blending = blendingOf(setup, area);
    if (blending.kind == Blending::BANDS)
        return cv::makePtr<TiledBlender>(blending.bands, deep);
    return blenderOf(blending);
}

cv::Ptr<detail::ExposureCompensator> compensatorOf(const StitchSetup& setup)
{
    typedef detail::ExposureCompensator E;
    const std::vector<std::string> names = compensatorNames();
    const int types[] = {E::NO, E::GAIN, E::GAIN_BLOCKS, E::CHANNELS, E::CHANNELS_BLOCKS}; // in the order of the names
    const auto found = std::find(names.begin(), names.end(), setup.expos_comp);
    CV_Assert(found != names.end());
    const cv::Ptr<E> compensator = E::createDefault(types[found - names.begin()]);
    if (const auto gain = compensator.dynamicCast<detail::GainCompensator>())
        gain->setNrFeeds(setup.expos_comp_nr_feeds);
    if (const auto channels = compensator.dynamicCast<detail::ChannelsCompensator>())
        channels->setNrFeeds(setup.expos_comp_nr_feeds);
    if (const auto blocks = compensator.dynamicCast<detail::BlocksCompensator>())
    {
        blocks->setNrFeeds(setup.expos_comp_nr_feeds);
        blocks->setNrGainsFilteringIterations(setup.expos_comp_nr_filtering);
        blocks->setBlockSize(setup.expos_comp_block_size, setup.expos_comp_block_size);
    }
    return compensator;
}

std::string plainSeam(const std::string& seam)
{
    return seam == OWN_SEAM ? "gc_color" : seam;
}

cv::Ptr<detail::SeamFinder> seamFinderOf(const StitchSetup& setup, const std::function<void(double)>& show)
{
    if (setup.seam == OWN_SEAM && show)
        return cv::makePtr<CountedSeams>(show);
    return choose<detail::SeamFinder>("seam", setup.seam, seams());
}

cv::Ptr<cv::Stitcher> makeStitcher(const StitchSetup& setup, MatchLog& log)
{
    const bool scans = setup.mode == "scans";
    const cv::Ptr<cv::Stitcher> stitcher = cv::Stitcher::create(scans ? cv::Stitcher::SCANS : cv::Stitcher::PANORAMA);
    stitcher->setRegistrationResol(setup.work_megapix);
    stitcher->setSeamEstimationResol(setup.seam_megapix);
    stitcher->setPanoConfidenceThresh(setup.conf_thresh);
    stitcher->setFeaturesFinder(choose<cv::Feature2D>("features", setup.features, finders()));
    stitcher->setFeaturesMatcher(matcherOf(setup, matchConfidence(setup), log));
    stitcher->setWarper(warperOf(orElse(setup.warp, scans ? "affine" : "spherical")));
    if (setup.estimator == "affine")
        stitcher->setEstimator(cv::makePtr<detail::AffineBasedEstimator>());
    if (setup.estimator == "homography")
        stitcher->setEstimator(cv::makePtr<detail::HomographyBasedEstimator>());
    if (!scans || !setup.ba.empty())
        stitcher->setBundleAdjuster(adjusterOf(setup, orElse(setup.ba, "ray")));
    stitcher->setWaveCorrection(setup.wave_correct.empty() ? !scans : setup.wave_correct != "no");
    stitcher->setWaveCorrectKind(setup.wave_correct == "vert" ? detail::WAVE_CORRECT_VERT : detail::WAVE_CORRECT_HORIZ);
    return stitcher;
}
