// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#ifndef OPENCV_GCPW_STITCHER_BINDING_HPP
#define OPENCV_GCPW_STITCHER_BINDING_HPP

#include <memory>
#include <string>
#include <vector>
#include "stitching/image_capture.hpp"
#include "stitching/rig_alignment.hpp"
#include "stitching/shared_state.hpp"
#include "opencv2/gcpw/stitcher.hpp"

namespace cv
{
namespace gcpw
{

/// Implements the hooks of SharedState. The stitcher owns it through its warper, so it must not own the stitcher.
class Binding : public StitcherBinding
{
public:
    Binding(const Ptr<Stitcher>& stitcher, const Params& params, const Progress& progress);

    std::shared_ptr<SharedState> shared_state() const { return shared_state_; }
    std::shared_ptr<CapturedImages> shown() const { return shown_; }

    const Rig& rig() const override { return shared_state_->rig; }
    void setRig(const Rig& rig) override;
    void setImages(InputArrayOfArrays images) override;
    int estimations() const override { return estimations_; }
    std::vector<std::string> replacedParts() const override;

    /// Remembers the parts that the stitcher has now, as those that belong to it.
    void installed();

    /// Called before each warper is made: the cameras are final then, and no image has been warped yet.
    void beforeCreate();

    /// Called by the other parts of ours in a running stitcher: without our warper there will be no beforeCreate().
    void atWork();

private:
    void noteReplacedParts();
    void estimate(Stitcher& stitcher, const std::vector<cv::detail::CameraParams>& cameras);
    std::vector<Mat> imagesOf(const std::vector<int>& component, double work_scale, size_t count) const;
    std::vector<KnownKeypoints> keypointsOf(const std::vector<int>& component, size_t count) const;

    struct Parts
    {
        std::weak_ptr<WarperCreator> warper;
        std::weak_ptr<cv::detail::ExposureCompensator> compensator;
        std::weak_ptr<Feature2D> finder;
        std::weak_ptr<cv::detail::FeaturesMatcher> matcher;
    };

    std::weak_ptr<Stitcher> stitcher_;
    Params params_;
    Progress progress_;
    std::shared_ptr<SharedState> shared_state_;
    std::shared_ptr<CapturedImages> shown_; ///< to the features finder
    std::vector<Mat> given_;                ///< by setImages()
    Parts parts_;
    std::vector<std::string> noted_; ///< replaced parts that were logged
    bool lasting_ = true;            ///< the rig, or the reason why it has no answer; see RigEstimate
    int estimations_ = 0;
};

} // namespace gcpw
} // namespace cv

#endif
