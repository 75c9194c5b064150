// Part of the GCPW module for OpenCV. Licence: Apache-2.0 (see LICENSE).
#include "adapters/affine_warper.hpp"
#include "adapters/session.hpp"
#include "opencv2/gcpw/compensator.hpp"
#include "opencv2/gcpw/warper.hpp"

namespace cv
{
namespace gcpw
{

GcpwWarper::GcpwWarper(const Ptr<WarperCreator>& base, const Rig& rig) : session_(std::make_shared<Session>())
{
    if (!base)
        CV_Error(Error::StsNullPtr, "gcpw: GcpwWarper needs a base warper");
    session_->base = base;
    session_->setRig(rig);
}

GcpwWarper::GcpwWarper(const std::shared_ptr<Session>& session) : session_(session) {}

Ptr<cv::detail::RotationWarper> GcpwWarper::create(float scale) const
{
    // The hook calls the user, who may replace the stitcher's warper, which is this object.
    const std::shared_ptr<Session> session = session_;
    if (session->before_create)
        session->before_create();
    const Ptr<cv::detail::RotationWarper> warper =
        makePtr<detail::GcpwWarper>(trueWarper(session->base->create(scale)), session->model);
    session->noteScale(scale);
    session->warper = warper;
    return warper;
}

const Rig& GcpwWarper::rig() const
{
    return session_->rig;
}

void GcpwWarper::setRig(const Rig& rig)
{
    session_->setRig(rig);
}

Ptr<WarperCreator> GcpwWarper::base() const
{
    return session_->base;
}

Ptr<GcpwCompensator> GcpwWarper::compensator(const Params& params) const
{
    return makePtr<GcpwCompensator>(params, session_);
}

} // namespace gcpw
} // namespace cv
