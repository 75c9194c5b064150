// Part of the GCPW module for OpenCV. Licence: Apache-2.0 (see LICENSE).
#include "opencv2/gcpw/stitcher.hpp"

#include <algorithm>
#include <opencv2/core/utils/logger.hpp>
#include <opencv2/imgproc.hpp>
#include "adapters/image_capture.hpp"
#include "adapters/session.hpp"

namespace cv
{
namespace gcpw
{

namespace
{

const size_t ENOUGH_KEYPOINTS = 1000; ///< in an image: from fewer, a mesh is poorly informed and more are looked for

/// What the session's hook needs; owned by the stitcher through its warper, so it must not own the stitcher.
class Binding : public StitcherBinding
{
public:
    Binding(const Ptr<Stitcher>& stitcher, const Params& params, const Progress& progress)
        : stitcher_(stitcher), params_(params), progress_(progress), session_(std::make_shared<Session>()),
          shown_(std::make_shared<Captured>())
    {
    }

    std::shared_ptr<Session> session() const { return session_; }
    std::shared_ptr<Captured> shown() const { return shown_; }

    const Rig& rig() const override { return session_->rig; }
    void setRig(const Rig& rig) override { session_->setRig(rig); }
    int estimations() const override { return estimations_; }

    void setImages(InputArrayOfArrays images) override
    {
        std::vector<UMat> umats;
        images.getUMatVector(umats);
        given_.assign(umats.size(), Mat());
        for (size_t i = 0; i < umats.size(); ++i)
            umats[i].copyTo(given_[i]);
    }

    /// Called before each warper is made: the cameras are final then, and no image has been warped yet.
    void beforeCreate()
    {
        const Ptr<Stitcher> stitcher = stitcher_.lock();
        if (!stitcher)
            return;
        const std::vector<cv::detail::CameraParams> cameras = stitcher->cameras();
        if (session_->rig.fits(cameras))
        {
            shown_->clear();
            return; // the same cameras, so the same rig, or the same reason why there is none
        }
        const std::vector<int> component = stitcher->component();
        const std::vector<Mat> images = imagesOf(component, stitcher->workScale(), cameras.size());
        const std::vector<KnownKeypoints> keypoints = keypointsOf(component, cameras.size());
        shown_->clear();
        Rig rig;
        if (images.empty())
        {
            Report report;
            report.status = Status::ROUGH;
            report.message = "the stitcher has shown no images of these cameras; the plain warper was used";
            rig.alignment = Alignment(std::vector<Alignment::Image>(), Size2d(1, 1), report);
            CV_LOG_WARNING(nullptr, "gcpw: " << report.message);
            session_->setRig(rig);
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
        rig = alignRig(images, cameras, session_->base, params, progress_, keypoints);
        if (component.size() == cameras.size())
            rig.component = component;
        rig.work_scale = stitcher->workScale();
        session_->setRig(rig);
    }

private:
    /// Images of the cameras at work scale, in their order; none if none were shown or given.
    std::vector<Mat> imagesOf(const std::vector<int>& component, double work_scale, size_t count) const
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
    std::vector<KnownKeypoints> keypointsOf(const std::vector<int>& component, size_t count) const
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

    std::weak_ptr<Stitcher> stitcher_;
    Params params_;
    Progress progress_;
    std::shared_ptr<Session> session_;
    std::shared_ptr<Captured> shown_; ///< to the features finder
    std::vector<Mat> given_;          ///< by setImages()
    int estimations_ = 0;
};

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

} // namespace

Ptr<StitcherBinding> attach(const Ptr<Stitcher>& stitcher, const Params& params, const Progress& progress)
{
    if (!stitcher)
        CV_Error(Error::StsNullPtr, "gcpw: attach() needs a stitcher");
    params.check();
    const Ptr<Binding> binding = makePtr<Binding>(stitcher, params, progress);
    binding->session()->base = plainWarper(stitcher);
    // The session is part of the binding: a strong reference here would never be released.
    const std::weak_ptr<Binding> weak = binding;
    binding->session()->before_create = [weak]
    {
        if (const Ptr<Binding> alive = weak.lock())
            alive->beforeCreate();
    };
    // The warper keeps the binding alive for callers who drop it.
    const std::shared_ptr<Session> session(binding, binding->session().get());
    stitcher->setWarper(makePtr<GcpwWarper>(session));
    const Ptr<GcpwCompensator> compensator = makePtr<GcpwCompensator>(params, session);
    compensator->setFallback(plainCompensator(stitcher));
    stitcher->setExposureCompensator(compensator);
    stitcher->setFeaturesFinder(makePtr<ImageCapture>(plainFinder(stitcher), binding->shown()));
    return binding;
}

} // namespace gcpw
} // namespace cv
