// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#ifndef OPENCV_GCPW_ROTATION_WARPER_HPP
#define OPENCV_GCPW_ROTATION_WARPER_HPP

#include <memory>
#include <opencv2/stitching/detail/warpers.hpp>
#include "opencv2/gcpw/rig.hpp"

namespace cv
{
namespace gcpw
{

class GcpwCompensator;
class GcpwWarper;
class RigModel;

//! @addtogroup gcpw
//! @{

/** @brief A base warper followed by the mesh of the image that the call is about. What GcpwWarper::create() returns.

@code
cv::gcpw::GcpwRotationWarper warper(cv::makePtr<cv::detail::SphericalWarper>(scale), rig);
cv::Mat picture;
const cv::Point corner = warper.warp(photo, K, rig.cameras[0].R, cv::INTER_LINEAR, cv::BORDER_REFLECT, picture);
@endcode

The image is known by its camera's R: all nine values, as CV_32F. Cameras with equal R are told apart by the order of the
calls since the warper was made, images and masks counted separately. A picture with one channel is taken for a mask if a picture
with several was warped before, or if it comes with INTER_NEAREST and BORDER_CONSTANT. An R that the rig does not contain
and an image whose mesh changes nothing get exactly the base warper.

The mesh moves the base warper's canvas, so the result shows the same at every scale. An image that crosses the seam of a
360-degree panorama has the base warper's full-width rectangle. cv::detail::AffineWarper is replaced by the affine map that it
stands for, because OpenCV's inverts the map by transposing it.

K and R of all members: 3 x 3, finite, any depth. Not thread-safe, as OpenCV's own warpers: it keeps the maps of the last image
and counts calls. */
class CV_EXPORTS GcpwRotationWarper : public cv::detail::RotationWarper
{
public:
    /** @brief The base warper followed by the meshes of a rig.
    @param base warper at the scale that this one is to have
    @param rig what to put behind it; one that is not usable() leaves the base warper; one that Rig::check()
    refuses is logged
    @throws cv::Exception StsNullPtr if there is no base */
    explicit GcpwRotationWarper(const Ptr<cv::detail::RotationWarper>& base, const Rig& rig = Rig());
    ~GcpwRotationWarper() CV_OVERRIDE;

    /** @brief Canvas position of a point of an image.
    @param pt pixels of the image
    @param K, R its camera
    @return pixels of the canvas
    @throws cv::Exception if K or R is not 3 x 3 or not finite; so do all members */
    Point2f warpPoint(const Point2f& pt, InputArray K, InputArray R) CV_OVERRIDE;

    /** @brief Point of an image at a canvas position; beside the mesh it is extrapolated from the border.
    @param pt pixels of the canvas
    @param K, R the image's camera
    @return pixels of the image; may lie beside it
    @throws cv::Exception see warpPoint() */
    Point2f warpPointBackward(const Point2f& pt, InputArray K, InputArray R) CV_OVERRIDE;

    /** @brief Maps for cv::remap.
    @param src_size of the image
    @param K, R its camera
    @param xmap, ymap CV_32FC1, of the size that warpRoi() gives: pixel of the image for each pixel of the canvas, (-1, -1) beside
    the mesh
    @return from the top-left to the bottom-right pixel, so one less than the maps' size, as all base warpers do
    @throws cv::Exception StsOutOfRange if a side would exceed 32766 px, before anything is allocated */
    Rect buildMaps(Size src_size, InputArray K, InputArray R, OutputArray xmap, OutputArray ymap) CV_OVERRIDE;

    /** @brief Warps an image.
    @param src of any type that cv::remap takes
    @param K, R its camera
    @param interp_mode see cv::InterpolationFlags
    @param border_mode see cv::BorderTypes; with BORDER_REFLECT, BORDER_REFLECT_101 and BORDER_REPLICATE colours go on smoothly
    beside the mesh
    @param dst of src's type and the size that warpRoi() gives
    @return canvas position of its top-left pixel
    @throws cv::Exception StsOutOfRange if a side would exceed 32766 px, before anything is allocated */
    Point warp(InputArray src, InputArray K, InputArray R, int interp_mode, int border_mode,
               OutputArray dst) CV_OVERRIDE;

    /** @brief Warps an image and its mask at once, with less memory: the same pixels as warp() with INTER_LINEAR and
    BORDER_REFLECT, and of the mask with INTER_NEAREST and BORDER_CONSTANT.

    No maps of the whole picture are made, but of some hundred rows at a time, and the picture may have sides of more than 32766 px.
    @param src of any type that cv::remap takes
    @param mask CV_8UC1 of src's size
    @param K, R the image's camera
    @param dst of src's type and the size that largeRoi() gives
    @param dst_mask CV_8UC1 of the same size
    @return canvas position of their top-left pixel
    @throws cv::Exception StsUnmatchedSizes if the mask is of another size */
    Point warpWithMask(InputArray src, InputArray mask, InputArray K, InputArray R, OutputArray dst,
                       OutputArray dst_mask);

    /** @brief warpRoi() without a limit of 32766 px: what warpWithMask() makes.
    @param src_size of the image
    @param K, R its camera
    @return the smallest rectangle with all pixels that the image covers
    @throws cv::Exception StsOutOfRange if a side would exceed a million px */
    Rect largeRoi(Size src_size, InputArray K, InputArray R);

    /** @brief Undoes warp().
    @param src picture of the canvas, of the size that warpRoi() gives for dst_size
    @param K, R the image's camera
    @param interp_mode, border_mode see cv::remap
    @param dst_size of the image
    @param dst the image, of src's type
    @throws cv::Exception StsUnmatchedSizes if src is of another size */
    void warpBackward(InputArray src, InputArray K, InputArray R, int interp_mode, int border_mode, Size dst_size,
                      OutputArray dst) CV_OVERRIDE;

    /** @brief Canvas pixels that an image covers.
    @param src_size of the image
    @param K, R its camera
    @return the smallest rectangle with all of them: corner and size of what warp() makes
    @throws cv::Exception StsOutOfRange if a side would exceed 32766 px */
    Rect warpRoi(Size src_size, InputArray K, InputArray R) CV_OVERRIDE;

    /// Scale of the base warper.
    /// @return pixels of the canvas per radian, or per pixel for the affine one
    float getScale() const CV_OVERRIDE;

    /// Also sets the scale of the base warper.
    /// @param scale pixels of the canvas per radian, > 0
    void setScale(float scale) CV_OVERRIDE;

private:
    friend struct PartFactory;
    GcpwRotationWarper(const Ptr<cv::detail::RotationWarper>& base, const std::shared_ptr<const RigModel>& model);

    class Impl;
    std::unique_ptr<Impl> impl_;
};

/** @brief GcpwRotationWarper with a base warper by its name, for languages without cv::detail::RotationWarper.

Has the members of cv::PyRotationWarper and takes its place in a stitching loop in Python:
@code{.py}
rig = cv2.gcpw.alignRig(images, cameras, "spherical")
warper = cv2.gcpw.PyGcpwWarper("spherical", scale, rig)
corner, picture = warper.warp(images[0], K, rig.cameras[0].R, cv2.INTER_LINEAR, cv2.BORDER_REFLECT)
@endcode */
class CV_EXPORTS_W PyGcpwWarper
{
public:
    /** @brief A warper of this name followed by the meshes of a rig.
    @param warper a name that alignRig() knows
    @param scale of the base warper, > 0
    @param rig see GcpwRotationWarper
    @throws cv::Exception StsBadArg if there is no warper of that name, or see Rig::check() */
    CV_WRAP PyGcpwWarper(const String& warper, float scale, const Rig& rig = Rig());

    /// See GcpwRotationWarper::warpPoint().
    /// @param pt pixels of the image  @param K, R its camera, 3 x 3
    /// @return pixels of the canvas
    CV_WRAP Point2f warpPoint(const Point2f& pt, InputArray K, InputArray R);

    /// See GcpwRotationWarper::warpPointBackward().
    /// @param pt pixels of the canvas  @param K, R the image's camera
    /// @return pixels of the image
    CV_WRAP Point2f warpPointBackward(const Point2f& pt, InputArray K, InputArray R);

    /// See GcpwRotationWarper::buildMaps().
    /// @param src_size of the image  @param K, R its camera  @param xmap, ymap CV_32FC1, pixel of the image for each of the canvas
    /// @return from the top-left to the bottom-right pixel, one less than the maps' size
    CV_WRAP Rect buildMaps(Size src_size, InputArray K, InputArray R, OutputArray xmap, OutputArray ymap);

    /// See GcpwRotationWarper::warp().
    /// @param src of any type that cv::remap takes  @param K, R its camera  @param interp_mode, border_mode see cv::remap
    /// @param dst of src's type and the size that warpRoi() gives
    /// @return canvas position of its top-left pixel
    CV_WRAP Point warp(InputArray src, InputArray K, InputArray R, int interp_mode, int border_mode, CV_OUT OutputArray dst);

    /// See GcpwRotationWarper::warpBackward().
    /// @param src picture of the canvas, of the size that warpRoi() gives for dst_size  @param K, R the image's camera
    /// @param interp_mode, border_mode see cv::remap  @param dst_size of the image  @param dst the image, of src's type
    CV_WRAP void warpBackward(InputArray src, InputArray K, InputArray R, int interp_mode, int border_mode, Size dst_size,
                              CV_OUT OutputArray dst);

    /// See GcpwRotationWarper::warpRoi().
    /// @param src_size of the image  @param K, R its camera
    /// @return canvas pixels that the image covers
    CV_WRAP Rect warpRoi(Size src_size, InputArray K, InputArray R);

    /** @brief A compensator with the colours of the rig, for what this and other warpers of the rig make, at any scale.
    @param params for GcpwCompensator::feed(), which estimates colours only while the rig is not usable()
    @return never empty
    @throws cv::Exception if params are out of range */
    CV_WRAP Ptr<GcpwCompensator> compensator(const Params& params = Params()) const;

    /// Scale of the base warper.
    /// @return pixels of the canvas per radian, or per pixel for the affine one
    CV_WRAP float getScale() const;

    /// Also sets the scale of the base warper.
    /// @param scale pixels of the canvas per radian, > 0
    CV_WRAP void setScale(float scale);

private:
    Ptr<GcpwWarper> creator_;
    Ptr<cv::detail::RotationWarper> warper_;
};

//! @}

} // namespace gcpw
} // namespace cv

#endif
