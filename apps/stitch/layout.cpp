// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#include "stitch/layout.hpp"

#ifdef __GLIBC__
#include <malloc.h>
#endif
#include "common/program.hpp"
#include "stitch/counted_finder.hpp"
#include "stitch/focal_start.hpp"
#include "stitch/model.hpp"

using namespace cv::gcpw;

const char* const READING = "reading";
const char* const MATCHING = "finding cameras";
const char* const ALIGNING = "aligning";
const char* const SEAMS = "cutting seams";
const char* const COMPOSING = "composing";

namespace
{

// Stages of the module's functions, with the shares of the time that they take of five photographs of 4 Mpx on two cores.
const char* const KEYPOINTS = "features";
const char* const CAMERAS = "cameras";
const std::vector<ProgressLine::Stage> FINDING = {{KEYPOINTS, 1}, {CAMERAS, 1}};
const std::vector<ProgressLine::Stage> ALIGNMENT = {{KEYPOINTS, 1}, {"homography", 2}, {"align", 6}};

/// Gives memory that features and matches have left behind back to the system, where the allocator keeps it.
void releaseFreedMemory()
{
#ifdef __GLIBC__
    malloc_trim(0);
#endif
}

/// 8 bits of each, BGR or BGRA: the same pixels where they have 8 bits already.
std::vector<cv::Mat> bytesOf(const std::vector<Photograph>& photographs)
{
    std::vector<cv::Mat> images;
    for (const Photograph& photograph : photographs)
        images.push_back(toBytes(photograph.image));
    return images;
}

/// What files note of focal lengths, px; 0 where one notes none.
std::vector<double> focalsOf(const std::vector<Photograph>& photographs)
{
    std::vector<double> focals;
    for (const Photograph& photograph : photographs)
        focals.push_back(photograph.metadata.focalLength(photograph.size()) * photograph.scale);
    return focals;
}

/// The parts that make the picture. @param base the warper without meshes
void addParts(const StitchJob& job, const cv::Ptr<cv::WarperCreator>& base, ProgressLine& progress, Layout& layout)
{
    layout.seam_finder = seamFinderOf(job.setup, [&progress](double share)
                                      { progress.show(SHARE_BEFORE_CUTS + (1 - SHARE_BEFORE_CUTS) * share); });
    layout.compensator = compensatorOf(job.setup);
    layout.warper = base;
    if (!job.gcpw)
        return;
    const auto gcpw = cv::makePtr<GcpwWarper>(base, layout.rig);
    layout.warper = gcpw;
    if (!job.plain_colors && layout.rig.usable())
        layout.compensator = gcpw->compensator(job.params);
}

void useModel(const StitchJob& job, const std::vector<Photograph>& photographs, ProgressLine& progress, Layout& layout)
{
    layout.rig = modelFor(photographs, job.load_model, job.setup.warp);
    layout.component = layout.rig.component;
    layout.cameras = layout.rig.cameras;
    layout.work_scale = layout.rig.work_scale;
    layout.projection = layout.rig.projection;
    layout.turned = layout.rig.turned;
    addParts(job, warperOf(layout.projection), progress, layout);
}

/// Looks for cameras and a projection in mode auto.
void findCameras(const StitchJob& job, const std::vector<Photograph>& photographs, MatchLog& log,
                 ProgressLine& progress, Layout& layout)
{
    CameraOptions options = cameraOptions(job.setup, log);
    options.focal = focalsOf(photographs);
    const bool reduced = photographs[0].scale < 1; // to what the estimation would reduce them to
    if (reduced)
        options.workMegapix = MOST_MEGAPIX;
    CameraEstimate estimate = estimateCameras(bytesOf(photographs), options, progress.callback(FINDING));
    if (reduced)
        estimate.work_scale = photographs[0].scale;
    releaseFreedMemory();
    layout.decisions = estimate.decisions;
    if (!estimate.ok())
    {
        layout.trouble = estimate.decisions.back() + "; take them with a third of overlap, or lower --conf_thresh";
        return;
    }
    layout.component = estimate.component;
    layout.cameras = estimate.cameras;
    layout.work_scale = estimate.work_scale;
    layout.projection = estimate.projection;
    layout.turned = estimate.turned;
    if (job.gcpw)
    {
        progress.begin(ALIGNING);
        layout.rig = alignRig(estimate, job.params, progress.callback(ALIGNMENT));
        layout.estimations = 1;
    }
    addParts(job, estimate.warper(), progress, layout);
}

/// OpenCV's own estimation, of the modes by name.
void estimateByStitcher(const StitchJob& job, const std::vector<Photograph>& photographs, MatchLog& log,
                        ProgressLine& progress, Layout& layout)
{
    const bool scans = job.setup.mode == "scans";
    std::vector<cv::Mat> images;
    std::vector<cv::Mat> masks;
    std::vector<int> widths;
    for (const Photograph& photograph : photographs)
    {
        images.push_back(withoutAlpha(toBytes(photograph.image)));
        const cv::Mat shown = shownPixels(photograph.image);
        masks.push_back(shown.empty() ? cv::Mat(images.back().size(), CV_8UC1, cv::Scalar(255)) : shown);
        widths.push_back(images.back().cols);
    }
    const cv::Ptr<cv::Stitcher> stitcher = makeStitcher(job.setup, log);
    if (!scans && job.setup.estimator.empty())
        stitcher->setEstimator(cv::makePtr<FocalStart>(focalsOf(photographs), widths));
    if (const Progress finding = progress.callback(FINDING))
    {
        stitcher->setFeaturesFinder(cv::makePtr<CountedFinder>(stitcher->featuresFinder(), images.size(),
                                                               [finding](double share) { finding(KEYPOINTS, share); }));
        log.onPair([finding](double share) { finding(CAMERAS, share); });
    }
    cv::Ptr<StitcherBinding> binding;
    if (job.gcpw)
        binding = attach(stitcher, job.params, progress.callback(ALIGNMENT));
    const cv::Stitcher::Status status = stitcher->estimateTransform(images, masks);
    if (status != cv::Stitcher::OK)
    {
        layout.trouble = explain(status) + ", lower --conf_thresh, or try --mode=auto";
        return;
    }
    layout.component = stitcher->component();
    layout.cameras = stitcher->cameras();
    layout.work_scale = stitcher->workScale();
    layout.projection = !job.setup.warp.empty() ? job.setup.warp : scans ? "affine" : "spherical";
    if (binding)
    {
        progress.begin(ALIGNING);
        stitcher->warper()->create(medianFocal(layout.cameras)); // here the binding aligns
        layout.rig = binding->rig();
        layout.estimations = binding->estimations();
    }
    addParts(job, warperOf(layout.projection), progress, layout);
}

} // namespace

Layout layOut(const StitchJob& job, const std::vector<Photograph>& photographs, MatchLog& log, ProgressLine& progress)
{
    Layout layout;
    progress.begin(MATCHING);
    if (!job.load_model.empty())
        useModel(job, photographs, progress, layout);
    else if (job.setup.mode == "auto")
        findCameras(job, photographs, log, progress, layout);
    else
        estimateByStitcher(job, photographs, log, progress, layout);
    releaseFreedMemory();
    return layout;
}
