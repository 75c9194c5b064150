// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#include "stitching/stitcher_binding.hpp"

#include <algorithm>
#include <exception>
#include <opencv2/core/utils/logger.hpp>
#include <opencv2/imgproc.hpp>
#include "stitching/rig_fault.hpp"

namespace cv
{
namespace gcpw
{

namespace
{

const size_t ENOUGH_KEYPOINTS = 1000; ///< in an image: from fewer, a mesh is poorly informed and more are looked for
const char* const WARPER = "warper";
const char* const COMPENSATOR = "exposure compensator";
const char* const FINDER = "features finder";
const char* const MATCHER = "features matcher";

template <typename Part>
bool replaced(const std::weak_ptr<Part>& own, const Ptr<Part>& present)
{
    const std::shared_ptr<Part> alive = own.lock();
    return !alive || alive.get() != present.get();
}

bool contains(const std::vector<std::string>& parts, const std::string& part)
{
    return std::find(parts.begin(), parts.end(), part) != parts.end();
}

} // namespace

Binding::Binding(const Ptr<Stitcher>& stitcher, const Params& params, const Progress& progress)
    : stitcher_(stitcher), params_(params), progress_(progress), shared_state_(std::make_shared<SharedState>()),
      shown_(std::make_shared<CapturedImages>())
{
}

void Binding::setRig(const Rig& rig)
{
    shared_state_->setRig(rig);
    // One whose parts contradict each other says nothing about the stitcher's cameras.
    lasting_ = rig.alignment.report().status != Status::CANCELLED && findFault(rig).message.empty();
}

void Binding::setImages(InputArrayOfArrays images)
{
    std::vector<UMat> umats;
    images.getUMatVector(umats);
    given_.assign(umats.size(), Mat());
    for (size_t i = 0; i < umats.size(); ++i)
        umats[i].copyTo(given_[i]);
    // The reason of the last failure was about other images, and the next warper is of another panorama.
    lasting_ = lasting_ && shared_state_->rig.usable();
    shared_state_->warper.reset();
}

void Binding::installed()
{
    if (const Ptr<Stitcher> stitcher = stitcher_.lock())
        parts_ = {stitcher->warper(), stitcher->exposureCompensator(), stitcher->featuresFinder(), stitcher->featuresMatcher()};
}

std::vector<std::string> Binding::replacedParts() const
{
    std::vector<std::string> parts;
    const Ptr<Stitcher> stitcher = stitcher_.lock();
    if (!stitcher)
        return parts;
    if (replaced(parts_.warper, stitcher->warper()))
        parts.push_back(WARPER);
    if (replaced(parts_.compensator, stitcher->exposureCompensator()))
        parts.push_back(COMPENSATOR);
    if (replaced(parts_.finder, stitcher->featuresFinder()))
        parts.push_back(FINDER);
    if (replaced(parts_.matcher, stitcher->featuresMatcher()))
        parts.push_back(MATCHER);
    return parts;
}

void Binding::noteReplacedParts()
{
    const std::vector<std::string> parts = replacedParts();
    for (const std::string& part : parts)
        if (!contains(noted_, part))
            CV_LOG_WARNING(nullptr, "gcpw: the stitcher's " << part << " was replaced after attach(); call attach() last");
    noted_ = parts;
}

void Binding::atWork()
{
    noteReplacedParts();
    if (!contains(noted_, WARPER))
        return;
    const std::string reason = "the stitcher's warper was replaced after attach()";
    if (shared_state_->rig.cameras.empty() && shared_state_->rig.alignment.report().message.compare(0, reason.size(), reason) == 0)
        return;
    // Meshes and colours are not those of the pictures to come.
    shared_state_->setRig(rigWithoutAnswer(std::vector<cv::detail::CameraParams>(), reason));
    logReason(shared_state_->rig);
}

void Binding::beforeCreate()
{
    const Ptr<Stitcher> stitcher = stitcher_.lock();
    if (!stitcher)
        return;
    noteReplacedParts();
    const std::vector<cv::detail::CameraParams> cameras = stitcher->cameras();
    const bool same = shared_state_->rig.fits(cameras);
    if (same && lasting_)
    {
        shown_->clear();
        return; // the same cameras, so the same rig, or the same reason why there is none
    }
    const bool fresh = shown_->fresh;
    shown_->fresh = false;
    if (same && !fresh && !shared_state_->warper.expired())
        return; // the second warper of a panorama, which is to have the answer of the first
    if (!same && !fresh)
        shown_->clear(); // they were other cameras' images
    estimate(*stitcher, cameras);
    if (lasting_)
        shown_->clear();
}

void Binding::estimate(Stitcher& stitcher, const std::vector<cv::detail::CameraParams>& cameras)
{
    // What stays if the callback throws: these cameras are still to be estimated.
    lasting_ = false;
    shared_state_->setRig(rigWithoutAnswer(cameras, "the estimate was not finished"));
    bool in_callback = false; // only what estimateRig() lets through
    try
    {
        const std::vector<int> component = stitcher.component();
        const std::vector<Mat> images = imagesOf(component, stitcher.workScale(), cameras.size());
        if (images.empty())
        {
            std::string reason = "the stitcher has shown no images of these cameras";
            if (contains(noted_, FINDER))
                reason += ": its features finder was replaced after attach()";
            shared_state_->setRig(rigWithoutAnswer(cameras, reason));
            logReason(shared_state_->rig);
            return;
        }
        ++estimations_;
        Params params = params_;
        if (params.referenceImage >= 0)
        {
            // The user counts the images given to the stitcher; some may have been dropped.
            const auto found = std::find(component.begin(), component.end(), params.referenceImage);
            params.referenceImage = found == component.end() ? -1 : static_cast<int>(found - component.begin());
        }
        const std::vector<KnownKeypoints> keypoints = keypointsOf(component, cameras.size());
        in_callback = true;
        RigEstimate result = estimateRig(images, cameras, shared_state_->base, params, progress_, keypoints);
        in_callback = false;
        if (component.size() == cameras.size())
            result.rig.component = component;
        result.rig.work_scale = stitcher.workScale();
        shared_state_->setRig(result.rig);
        lasting_ = result.lasting;
    }
    catch (const std::exception& e)
    {
        if (in_callback)
            throw;
        const cv::Exception* known = dynamic_cast<const cv::Exception*>(&e);
        shared_state_->setRig(rigWithoutAnswer(cameras, known && !known->err.empty() ? known->err : e.what()));
        logReason(shared_state_->rig);
    }
}

/// Images of the cameras at work scale, in their order; none if none were shown or given.
std::vector<Mat> Binding::imagesOf(const std::vector<int>& component, double work_scale, size_t count) const
{
    std::vector<Mat> images;
    const std::vector<Mat>& source = given_.empty() ? shown_->images : given_;
    const bool whole = source.size() == count && source.size() != component.size();
    for (size_t i = 0; i < count; ++i)
    {
        const size_t index = whole || i >= component.size() ? i : static_cast<size_t>(component[i]);
        if (index >= source.size() || source[index].empty())
            return {};
        Mat image = source[index];
        if (!given_.empty() && work_scale != 1)
            resize(source[index], image, Size(), work_scale, work_scale, INTER_LINEAR_EXACT);
        images.push_back(image);
    }
    return images;
}

/// What the stitcher's own finder found in them, if that is of use here.
std::vector<KnownKeypoints> Binding::keypointsOf(const std::vector<int>& component, size_t count) const
{
    std::vector<KnownKeypoints> keypoints;
    if (!given_.empty() || shown_->keypoints.size() != shown_->images.size() || component.size() != count)
        return keypoints;
    for (const int index : component)
    {
        if (index >= static_cast<int>(shown_->keypoints.size()) || shown_->keypoints[index].points.size() < ENOUGH_KEYPOINTS)
            return {};
        keypoints.push_back(shown_->keypoints[index]);
    }
    return keypoints;
}

} // namespace gcpw
} // namespace cv
