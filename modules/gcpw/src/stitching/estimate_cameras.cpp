// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#include "opencv2/gcpw/cameras.hpp"

#include <algorithm>
#include <cmath>
#include <opencv2/core/utils/logger.hpp>
#include <opencv2/imgproc.hpp>
#include "cameras/camera_search.hpp"
#include "cameras/link_check.hpp"
#include "opencv2/gcpw/warper.hpp"
#include "registration/features_header.hpp"
#include "stitching/affine_warper.hpp"
#include "stitching/image_capture.hpp"
#include "stitching/seeded_matcher.hpp"
#include "stitching/steps.hpp"
#include "stitching/warper_names.hpp"

namespace cv
{
namespace gcpw
{

namespace
{

const int MOST_KEYPOINTS = 4000;
const double CONTRAST = 0.007; ///< of SIFT: at OpenCV's 0.04 faint and dark photographs have hardly a keypoint
const float STRICT = 0.65F;    ///< of the first matcher: few wrong matches, as stitching_detailed has it for SIFT
const float LOOSE = 0.25F;     ///< of the second: the usual ratio of 0.75 of the nearest to the second nearest

Ptr<Feature2D> finderOf(const CameraOptions& options)
{
    return options.finder ? options.finder : Ptr<Feature2D>(SIFT::create(MOST_KEYPOINTS, 3, CONTRAST));
}

Ptr<cv::detail::FeaturesMatcher> matcherOr(const Ptr<cv::detail::FeaturesMatcher>& given, float confidence)
{
    return given ? given
                 : Ptr<cv::detail::FeaturesMatcher>(makePtr<cv::detail::BestOf2NearestMatcher>(false, confidence));
}

std::vector<Mat> checked(InputArrayOfArrays photographs, const CameraOptions& options)
{
    std::vector<Mat> images;
    photographs.getMatVector(images);
    CV_CheckGE(images.size(), size_t(2), "gcpw: estimateCameras() takes two photographs or more");
    for (const Mat& image : images)
    {
        CV_Check(image.size(), !image.empty(), "gcpw: estimateCameras() takes no empty photograph");
        CV_CheckType(image.type(), image.type() == CV_8UC3 || image.type() == CV_8UC4 || image.type() == CV_8UC1,
                     "gcpw: estimateCameras() takes photographs of 8 bits: BGR, BGRA or gray");
    }
    CV_CheckGT(options.workMegapix, 0.0, "gcpw: CameraOptions::workMegapix is million pixels, more than 0");
    CV_CheckGT(options.confidence, 0.0, "gcpw: CameraOptions::confidence is more than 0");
    if (!options.focal.empty())
        CV_CheckEQ(options.focal.size(), images.size(),
                   "gcpw: CameraOptions::focal has one length for each photograph, or none");
    for (const double focal : options.focal)
        CV_Check(focal, focal >= 0 && std::isfinite(focal),
                 "gcpw: CameraOptions::focal is pixels, 0 where it is not known");
    if (!options.projection.empty())
        warperOfName(options.projection);
    return images;
}

/// 1-based numbers for people.
std::string numbersOf(const std::vector<int>& images)
{
    std::string text;
    for (size_t i = 0; i < images.size(); ++i)
        text += (i == 0 ? "" : i + 1 == images.size() ? " and " : ", ") + std::to_string(images[i] + 1);
    return text;
}

/// OpenCV calls a pair with a confidence above 3 "too close" and forgets it. These are the best there are.
void keepTheBest(std::vector<cv::detail::MatchesInfo>& matches)
{
    for (cv::detail::MatchesInfo& info : matches)
        if (info.confidence == 0 && !info.H.empty())
            info.confidence = info.num_inliers / (8 + 0.3 * static_cast<double>(info.matches.size()));
}

/// The keypoints of all photographs.
std::vector<cv::detail::ImageFeatures> featuresOf(const std::vector<Mat>& images, const CameraOptions& options,
                                                  Steps& steps)
{
    const Ptr<Feature2D> finder = finderOf(options);
    std::vector<cv::detail::ImageFeatures> features;
    steps.begin("features", 0, 1, static_cast<int>(images.size()));
    for (size_t i = 0; i < images.size() && !steps.cancelled(); ++i)
    {
        // As of all at once: that of a single one finds other keypoints.
        std::vector<cv::detail::ImageFeatures> one;
        cv::detail::computeImageFeatures(finder, std::vector<Mat>{images[i]}, one);
        features.push_back(one.at(0));
        features.back().img_idx = static_cast<int>(i); // OpenCV leaves it as it is
        steps.next();
    }
    return features;
}

/// Keypoints and matches of all photographs; links that need it are confirmed by the pictures. Not complete if the caller cancels.
LinkedImages link(const std::vector<Mat>& images, const CameraOptions& options, Steps& steps,
                  std::vector<std::string>& decisions)
{
    const double first_share = 0.8; // of the time that matching and confirming take
    LinkedImages linked;
    linked.features = featuresOf(images, options, steps);
    if (steps.cancelled())
        return linked;
    steps.begin("cameras", 0, first_share, linked.count() * (linked.count() - 1) / 2);
    const auto on_pair = [&steps]
    {
        steps.next();
        return !steps.cancelled();
    };
    SeededMatcher first(matcherOr(options.matcher, STRICT), on_pair);
    first(linked.features, linked.matches);
    first.collectGarbage();
    if (steps.cancelled())
        return linked;
    keepTheBest(linked.matches);
    const std::vector<int> groups = groupsOf(linked, options.confidence);
    if (*std::max_element(groups.begin(), groups.end()) == 0)
        return linked;
    Mat mask(linked.count(), linked.count(), CV_8U, Scalar(0));
    for (int a = 0; a < linked.count(); ++a)
        for (int b = a + 1; b < linked.count(); ++b)
            mask.at<uchar>(a, b) = groups[a] != groups[b] ? 1 : 0;
    std::vector<cv::detail::MatchesInfo> again;
    steps.begin("cameras", first_share, 1, countNonZero(mask));
    SeededMatcher second(matcherOr(options.secondMatcher, LOOSE), on_pair);
    second(linked.features, again, mask.getUMat(ACCESS_READ));
    second.collectGarbage();
    if (steps.cancelled())
        return linked;
    keepTheBest(again);
    for (size_t k = 0; k < again.size(); ++k)
        if (again[k].num_inliers > linked.matches[k].num_inliers)
            linked.matches[k] = again[k];
    for (cv::detail::MatchesInfo& info : linked.matches)
        if (info.src_img_idx >= 0 && info.dst_img_idx >= 0 && groups[info.src_img_idx] != groups[info.dst_img_idx])
            info.confidence = std::min(info.confidence, 0.99 * options.confidence);
    for (const Vec2i& pair : confirmLinks(linked, images, options.confidence))
        decisions.push_back("photographs " + numbersOf({pair[0], pair[1]}) +
                            " were linked because their overlap looks the same, though few of their keypoints match");
    return linked;
}

std::vector<KnownKeypoints> keypointsOf(const LinkedImages& linked)
{
    std::vector<KnownKeypoints> known(linked.features.size());
    for (size_t i = 0; i < known.size(); ++i)
    {
        KeyPoint::convert(linked.features[i].keypoints, known[i].points);
        linked.features[i].descriptors.copyTo(known[i].descriptors);
        if (!areEnough(known[i]))
            return {};
    }
    return known;
}

} // namespace

CameraOptions::CameraOptions() : workMegapix(0.6), confidence(1) {}

Ptr<WarperCreator> CameraEstimate::warper() const
{
    const Ptr<WarperCreator> named = warperOfName(projection);
    // OpenCV's own affine warper is right only without zoom; what stands in its place here is right.
    if (named.dynamicCast<cv::AffineWarper>())
        return makePtr<GcpwWarper>(named);
    return named;
}

CameraEstimate estimateCameras(InputArrayOfArrays photographs, const CameraOptions& options, const Progress& progress)
{
    const std::vector<Mat> given = checked(photographs, options);
    CameraEstimate estimate;
    // As cv::Stitcher has it: the first photograph's size gives one scale for all.
    estimate.work_scale = std::min(1.0, std::sqrt(options.workMegapix * 1e6 / static_cast<double>(given[0].total())));
    std::vector<Mat> images(given.size());
    for (size_t i = 0; i < given.size(); ++i)
        if (estimate.work_scale < 1)
            resize(given[i], images[i], Size(), estimate.work_scale, estimate.work_scale, INTER_LINEAR_EXACT);
        else
            images[i] = given[i];
    Steps steps(progress);
    LinkedImages linked = link(images, options, steps, estimate.decisions);
    if (steps.cancelled())
    {
        estimate.decisions.emplace_back("cancelled before cameras were found");
        return estimate;
    }
    for (const double focal : options.focal)
        linked.focals.push_back(focal * estimate.work_scale);
    const WarperMaker make = [](const std::string& name, float scale)
    { return trueWarper(warperOfName(name)->create(scale)); };
    const CameraChoice choice = searchCameras(linked, options.confidence, make, options.projection);
    estimate.decisions.insert(estimate.decisions.end(), choice.decisions.begin(), choice.decisions.end());
    if (!choice.cameras.empty())
    {
        estimate.component = choice.component;
        estimate.cameras = choice.cameras;
        estimate.projection = choice.projection;
        estimate.turned = choice.turned;
        for (const int i : choice.component)
            estimate.images.push_back(images[i]);
        if (finderOf(options).dynamicCast<SIFT>())
            estimate.keypoints = keypointsOf(subset(linked, choice.component));
        std::vector<int> dropped;
        for (int i = 0; i < static_cast<int>(given.size()); ++i)
            if (!std::binary_search(choice.component.begin(), choice.component.end(), i))
                dropped.push_back(i);
        if (!dropped.empty())
            estimate.decisions.push_back((dropped.size() == 1 ? "photograph " : "photographs ") + numbersOf(dropped) +
                                         (dropped.size() == 1 ? " was" : " were") +
                                         " left out: nothing links them to the others");
    }
    steps.begin("cameras", 1, 1, 0);
    for (const std::string& decision : estimate.decisions)
        CV_LOG_INFO(nullptr, "gcpw: " << decision);
    return estimate;
}

Rig alignRig(const CameraEstimate& estimate, const Params& params, const Progress& progress)
{
    CV_Check(estimate.cameras.size(), estimate.ok(),
             "gcpw: alignRig() takes an estimate with cameras: see CameraEstimate::decisions");
    Params own = params;
    if (params.referenceImage >= 0)
    {
        // Of a photograph that was left out nothing can be kept in its place.
        const auto found =
            std::lower_bound(estimate.component.begin(), estimate.component.end(), params.referenceImage);
        const bool kept = found != estimate.component.end() && *found == params.referenceImage;
        own.referenceImage = kept ? static_cast<int>(found - estimate.component.begin()) : -1;
    }
    Rig rig = alignRig(estimate.images, estimate.cameras, estimate.warper(), own, progress, estimate.keypoints);
    rig.component = estimate.component;
    rig.work_scale = estimate.work_scale;
    rig.projection = estimate.projection;
    rig.turned = estimate.turned;
    return rig;
}

} // namespace gcpw
} // namespace cv
