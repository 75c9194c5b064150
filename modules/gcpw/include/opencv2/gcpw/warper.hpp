// Part of the GCPW module for OpenCV. Licence: Apache-2.0 (see LICENSE).
#ifndef OPENCV_GCPW_WARPER_HPP
#define OPENCV_GCPW_WARPER_HPP

#include <memory>
#include <opencv2/stitching/detail/warpers.hpp>
#include "opencv2/gcpw/rig.hpp"

namespace cv
{
namespace gcpw
{

class RigModel;
struct Session;

//! @addtogroup gcpw
//! @{

namespace detail
{

/** @brief A base warper followed by the mesh of the image the call is about.

The image is known by its camera's R: all nine values, as CV_32F. Two cameras with equal R are told apart by the order of the
calls, images and masks each from the first one of a new warper on: a mask has one channel, and where photographs have one too
it is what INTER_NEAREST and BORDER_CONSTANT come with. An R that the rig does not know gets the base warper. An image whose mesh rests gets exactly the base warper.

The mesh moves the base warper's canvas, so it is the same picture at every scale. An image that straddles the seam of a
360-degree panorama keeps the base warper's full-width rectangle.
cv::detail::AffineWarper is replaced by the affine map it stands for: OpenCV's inverts it by transposing.
Not for two threads at once, as OpenCV's own warpers: it keeps the maps of the last image and counts calls. */
class CV_EXPORTS GcpwWarper : public cv::detail::RotationWarper
{
public:
    /// @param base at the scale this warper is to have  @param model may be empty: then this is the base warper
    GcpwWarper(const Ptr<cv::detail::RotationWarper>& base, const std::shared_ptr<const RigModel>& model);
    ~GcpwWarper() CV_OVERRIDE;

    Point2f warpPoint(const Point2f& pt, InputArray K, InputArray R) CV_OVERRIDE;

    /// Also answers beside the mesh, by going on as it ends.
    Point2f warpPointBackward(const Point2f& pt, InputArray K, InputArray R) CV_OVERRIDE;

    /** @brief Maps for cv::remap, CV_32FC1, of the size of warpRoi(); (-1, -1) beside the mesh.
    @return from the top-left to the bottom-right pixel, one less than the maps' size, as all base warpers do */
    Rect buildMaps(Size src_size, InputArray K, InputArray R, OutputArray xmap, OutputArray ymap) CV_OVERRIDE;

    /// @throws cv::Exception StsOutOfRange, before anything is allocated, if a side would exceed 32766 px
    Point warp(InputArray src, InputArray K, InputArray R, int interp_mode, int border_mode,
               OutputArray dst) CV_OVERRIDE;

    /// @throws cv::Exception if src is not of the size that warpRoi() gives
    void warpBackward(InputArray src, InputArray K, InputArray R, int interp_mode, int border_mode, Size dst_size,
                      OutputArray dst) CV_OVERRIDE;

    Rect warpRoi(Size src_size, InputArray K, InputArray R) CV_OVERRIDE;

    float getScale() const CV_OVERRIDE;
    void setScale(float scale) CV_OVERRIDE;

private:
    class Impl;
    std::unique_ptr<Impl> impl_;
};

} // namespace detail

class GcpwCompensator;

/** @brief Puts the mesh of a rig behind any warper: `stitcher->setWarper(makePtr<GcpwWarper>(base, rig))`. */
class CV_EXPORTS GcpwWarper : public WarperCreator
{
public:
    /// @throws cv::Exception if there is no base, or see Rig::check()
    explicit GcpwWarper(const Ptr<WarperCreator>& base, const Rig& rig = Rig());

    Ptr<cv::detail::RotationWarper> create(float scale) const CV_OVERRIDE;

    const Rig& rig() const;

    /// @throws cv::Exception see Rig::check(); the old rig is kept then
    void setRig(const Rig& rig);
    Ptr<WarperCreator> base() const;

    /// The compensator with the rig's colours, at the scale of whichever warper made the picture.
    Ptr<GcpwCompensator> compensator(const Params& params = Params()) const;

    /// Shared by the warper, the compensator and the stitcher's binding.
    explicit GcpwWarper(const std::shared_ptr<Session>& session);

private:
    std::shared_ptr<Session> session_;
};

//! @}

} // namespace gcpw
} // namespace cv

#endif
