// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#include "opencv2/gcpw/warper.hpp"

#include "stitching/affine_warper.hpp"
#include "stitching/part_factory.hpp"
#include "stitching/shared_state.hpp"

namespace cv
{
namespace gcpw
{

GcpwWarper::GcpwWarper(const Ptr<WarperCreator>& base, const Rig& rig) : shared_state_(std::make_shared<SharedState>())
{
    if (!base)
        CV_Error(Error::StsNullPtr, "gcpw: GcpwWarper needs a base warper");
    shared_state_->base = base;
    shared_state_->setRig(rig);
}

GcpwWarper::GcpwWarper(const std::shared_ptr<SharedState>& shared_state) : shared_state_(shared_state) {}

Ptr<cv::detail::RotationWarper> GcpwWarper::create(float scale) const
{
    // The hook calls the user, who may replace the stitcher's warper, which is this object.
    const std::shared_ptr<SharedState> shared_state = shared_state_;
    if (shared_state->before_create)
        shared_state->before_create();
    const Ptr<cv::detail::RotationWarper> warper =
        PartFactory::rotationWarper(trueWarper(shared_state->base->create(scale)), shared_state->model);
    shared_state->noteScale(scale);
    shared_state->warper = warper;
    return warper;
}

const Rig& GcpwWarper::rig() const
{
    return shared_state_->rig;
}

void GcpwWarper::setRig(const Rig& rig)
{
    shared_state_->setRig(rig);
}

Ptr<WarperCreator> GcpwWarper::base() const
{
    return shared_state_->base;
}

Ptr<GcpwCompensator> GcpwWarper::compensator(const Params& params) const
{
    return PartFactory::compensator(params, shared_state_);
}

} // namespace gcpw
} // namespace cv
