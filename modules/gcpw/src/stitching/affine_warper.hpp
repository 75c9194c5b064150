// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#ifndef OPENCV_GCPW_AFFINE_WARPER_HPP
#define OPENCV_GCPW_AFFINE_WARPER_HPP

#include <functional>
#include <opencv2/stitching/detail/warpers.hpp>

namespace cv
{
namespace gcpw
{

/** @brief The affine warper as it is meant: image = K R (canvas / scale), R any invertible affine map.

cv::detail::AffineWarper inverts R by transposing it, which is right only for a rotation without zoom. */
class AffineWarper : public cv::detail::RotationWarper
{
public:
    explicit AffineWarper(float scale) : scale_(scale) {}

    Point2f warpPoint(const Point2f& pt, InputArray K, InputArray R) override;
    Point2f warpPointBackward(const Point2f& pt, InputArray K, InputArray R) override;
    Rect buildMaps(Size src_size, InputArray K, InputArray R, OutputArray xmap, OutputArray ymap) override;
    Point warp(InputArray src, InputArray K, InputArray R, int interp_mode, int border_mode, OutputArray dst) override;
    void warpBackward(InputArray src, InputArray K, InputArray R, int interp_mode, int border_mode, Size dst_size,
                      OutputArray dst) override;
    Rect warpRoi(Size src_size, InputArray K, InputArray R) override;
    float getScale() const override { return scale_; }
    void setScale(float scale) override { scale_ = scale; }

    /// What buildMaps() puts into a pixel of the canvas.
    std::function<Point2f(int, int)> imageAt(InputArray K, InputArray R) const;

private:
    Matx33d imageFromCanvas(InputArray K, InputArray R) const;

    float scale_;
};

/// @throws cv::Exception StsUnmatchedSizes if a picture is not of the size that warpRoi() gives
void checkPicture(Size picture, Size expected);

/// The same base warper, or AffineWarper in the place of OpenCV's.
Ptr<cv::detail::RotationWarper> trueWarper(const Ptr<cv::detail::RotationWarper>& base);

} // namespace gcpw
} // namespace cv

#endif
