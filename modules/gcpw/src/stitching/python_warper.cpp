// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#include "opencv2/gcpw/rotation_warper.hpp"

#include <opencv2/stitching/warpers.hpp>
#include "opencv2/gcpw/compensator.hpp"
#include "opencv2/gcpw/warper.hpp"
#include "stitching/warper_names.hpp"

namespace cv
{
namespace gcpw
{

namespace
{

float positive(float scale)
{
    if (!(scale > 0))
        CV_Error(Error::StsOutOfRange, format("gcpw: the scale of a warper is %g, must be > 0", scale));
    return scale;
}

} // namespace

PyGcpwWarper::PyGcpwWarper(const String& warper, float scale, const Rig& rig)
    : creator_(makePtr<GcpwWarper>(warperOfName(warper), rig)), warper_(creator_->create(positive(scale)))
{
}

Point2f PyGcpwWarper::warpPoint(const Point2f& pt, InputArray K, InputArray R)
{
    return warper_->warpPoint(pt, K, R);
}

Point2f PyGcpwWarper::warpPointBackward(const Point2f& pt, InputArray K, InputArray R)
{
    return warper_->warpPointBackward(pt, K, R);
}

Rect PyGcpwWarper::buildMaps(Size src_size, InputArray K, InputArray R, OutputArray xmap, OutputArray ymap)
{
    return warper_->buildMaps(src_size, K, R, xmap, ymap);
}

Point PyGcpwWarper::warp(InputArray src, InputArray K, InputArray R, int interp_mode, int border_mode, OutputArray dst)
{
    return warper_->warp(src, K, R, interp_mode, border_mode, dst);
}

void PyGcpwWarper::warpBackward(InputArray src, InputArray K, InputArray R, int interp_mode, int border_mode,
                                Size dst_size, OutputArray dst)
{
    warper_->warpBackward(src, K, R, interp_mode, border_mode, dst_size, dst);
}

Rect PyGcpwWarper::warpRoi(Size src_size, InputArray K, InputArray R)
{
    return warper_->warpRoi(src_size, K, R);
}

Ptr<GcpwCompensator> PyGcpwWarper::compensator(const Params& params) const
{
    return creator_->compensator(params);
}

float PyGcpwWarper::getScale() const
{
    return warper_->getScale();
}

void PyGcpwWarper::setScale(float scale)
{
    warper_->setScale(positive(scale));
}

} // namespace gcpw
} // namespace cv
