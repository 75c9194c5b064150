// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#include "stitch/compose.hpp"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>
#include "common/deep_exposure.hpp"

namespace
{

const double SAME_SCALE = 0.1; ///< nearer to 1 photographs are not scaled, as cv::Stitcher has it
/// What blenders get of 16 bits: they add up weighted values in 15 bits, and up to four photographs lie over each other. 13 bits are left.
const double TO_DEEP = 1 / 8.0;

double scaleFor(double megapix, cv::Size size)
{
    return megapix > 0 ? std::min(1.0, std::sqrt(megapix * 1e6 / size.area())) : 1.0;
}

cv::Mat scaled(const cv::Mat& image, double scale)
{
    cv::Mat result;
    cv::resize(image, result, cv::Size(), scale, scale, cv::INTER_LINEAR_EXACT);
    return result;
}

/// The pixels to be shown of a photograph of a given size: next to transparent ones nothing is mixed in from them.
cv::Mat maskOf(const cv::Mat& image, cv::Size size)
{
    cv::Mat shown = shownPixels(image);
    if (shown.empty())
        return cv::Mat(size, CV_8UC1, cv::Scalar(255));
    if (shown.size() != size)
        cv::resize(shown, shown, size, 0, 0, cv::INTER_AREA);
    cv::Mat inside;
    cv::erode(shown == 255, inside, cv::Mat());
    return inside;
}

cv::Mat intrinsics(const cv::detail::CameraParams& camera)
{
    cv::Mat K;
    camera.K().convertTo(K, CV_32F);
    return K;
}

} // namespace

double seamScale(const StitchJob& job, const Photograph& first)
{
    return scaleFor(job.setup.seam_megapix, first.size());
}

SeamCopy seamCopy(const cv::Mat& photograph, double scale)
{
    SeamCopy copy;
    copy.image = scaled(withoutAlpha(toBytes(photograph)), scale);
    copy.mask = maskOf(photograph, copy.image.size());
    return copy;
}

std::vector<cv::UMat> findSeams(const Layout& layout, double seam_scale, const std::function<SeamCopy(size_t)>& copy_of,
                                ProgressLine& progress)
{
    const double aspect = seam_scale / layout.work_scale;
    const cv::Ptr<cv::detail::RotationWarper> warper =
        layout.warper->create(static_cast<float>(cv::gcpw::medianFocal(layout.cameras) * aspect));
    const size_t count = layout.cameras.size();
    std::vector<cv::Point> corners(count);
    std::vector<cv::UMat> images(count);
    std::vector<cv::UMat> masks(count);
    for (size_t k = 0; k < count; ++k)
    {
        const SeamCopy copy = copy_of(static_cast<size_t>(layout.component[k]));
        cv::Mat K = intrinsics(layout.cameras[k]);
        K.rowRange(0, 2) *= static_cast<float>(aspect);
        const cv::Mat& R = layout.cameras[k].R;
        corners[k] = warper->warp(copy.image, K, R, cv::INTER_LINEAR, cv::BORDER_REFLECT, images[k]);
        warper->warp(copy.mask, K, R, cv::INTER_NEAREST, cv::BORDER_CONSTANT, masks[k]);
        progress.show(SHARE_BEFORE_CUTS * static_cast<double>(k + 1) / static_cast<double>(count));
    }
    layout.compensator->feed(corners, images, masks);
    std::vector<cv::UMat> floats(count);
    for (size_t k = 0; k < count; ++k)
    {
        layout.compensator->apply(static_cast<int>(k), corners[k], images[k], masks[k]);
        images[k].convertTo(floats[k], CV_32F);
    }
    layout.seam_finder->find(floats, corners, masks);
    return masks;
}

cv::Mat fedImage(const cv::Mat& image, bool deep)
{
    cv::Mat fed;
    image.convertTo(fed, CV_16S, deep ? TO_DEEP : 1);
    return fed;
}

cv::Mat cutMask(const cv::UMat& seam, const cv::Mat& shown)
{
    // The seam at the picture's resolution, a little beyond itself, so that no gap is left.
    cv::UMat cut;
    cv::dilate(seam, cut, cv::Mat());
    cv::resize(cut, cut, shown.size(), 0, 0, cv::INTER_LINEAR_EXACT);
    cv::Mat mask;
    cv::bitwise_and(cut, shown, mask);
    return mask;
}

cv::Mat finished(const cv::Mat& blended, bool deep)
{
    cv::Mat picture;
    if (deep)
        blended.convertTo(picture, CV_16U, 1 / TO_DEEP);
    else
        blended.convertTo(picture, CV_8U);
    return picture;
}

double composeScale(const StitchJob& job, const std::vector<Photograph>& photographs, const Layout& layout)
{
    return scaleFor(job.setup.compose_megapix, photographs[static_cast<size_t>(layout.component[0])].size());
}

Warping::Warping(const StitchJob& job, const std::vector<Photograph>& photographs, const Layout& layout, bool deep,
                 bool large)
    : photographs_(photographs), layout_(layout), deep_(deep), cameras_(layout.cameras)
{
    scale_ = composeScale(job, photographs, layout);
    const double aspect = scale_ / layout.work_scale;
    warper_ = layout.warper->create(static_cast<float>(cv::gcpw::medianFocal(layout.cameras) * aspect));
    if (large)
    {
        large_ = warper_.dynamicCast<cv::gcpw::GcpwRotationWarper>();
        CV_Assert(large_);
    }
    for (size_t k = 0; k < cameras_.size(); ++k)
    {
        cameras_[k].ppx *= aspect;
        cameras_[k].ppy *= aspect;
        cameras_[k].focal *= aspect;
        cv::Size size = photographs[static_cast<size_t>(layout.component[k])].size();
        if (std::abs(scale_ - 1) > SAME_SCALE)
            size = cv::Size(cvRound(size.width * scale_), cvRound(size.height * scale_));
        const cv::Mat K = intrinsics(cameras_[k]);
        const cv::Rect roi =
            large_ ? large_->largeRoi(size, K, cameras_[k].R) : warper_->warpRoi(size, K, cameras_[k].R);
        corners_.push_back(roi.tl());
        sizes_.push_back(roi.size());
    }
}

Warping::Warped Warping::warp(size_t k)
{
    return warp(k, photographs_[static_cast<size_t>(layout_.component[k])].image);
}

Warping::Warped Warping::warp(size_t k, const cv::Mat& photograph)
{
    cv::Mat image = withoutAlpha(photograph);
    if (deep_ && image.depth() == CV_8U)
        image.convertTo(image, CV_16U, 257);
    if (!deep_)
        image = toBytes(image);
    if (std::abs(scale_ - 1) > SAME_SCALE)
        image = scaled(image, scale_);
    const cv::Mat K = intrinsics(cameras_[k]);
    Warped warped;
    if (large_)
    {
        warped.corner =
            large_->warpWithMask(image, maskOf(photograph, image.size()), K, cameras_[k].R, warped.image, warped.mask);
        return warped;
    }
    warped.corner = warper_->warp(image, K, cameras_[k].R, cv::INTER_LINEAR, cv::BORDER_REFLECT, warped.image);
    warper_->warp(maskOf(photograph, image.size()), K, cameras_[k].R, cv::INTER_NEAREST, cv::BORDER_CONSTANT,
                  warped.mask);
    return warped;
}

Composition compose(const StitchJob& job, const std::vector<Photograph>& photographs, const Layout& layout, bool deep,
                    ProgressLine& progress,
                    const std::function<void(size_t, const Warping&, const Warping::Warped&)>& on_warped)
{
    progress.begin(SEAMS);
    const double seam_scale = seamScale(job, photographs[0]);
    std::vector<cv::UMat> seams =
        findSeams(layout, seam_scale, [&](size_t i) { return seamCopy(photographs[i].image, seam_scale); }, progress);
    progress.begin(COMPOSING);
    Warping warping(job, photographs, layout, deep);
    const cv::Rect canvas = cv::detail::resultRoi(warping.corners(), warping.sizes());
    const cv::Ptr<cv::detail::Blender> blender = blenderOf(job.setup, canvas.area(), deep);
    blender->prepare(warping.corners(), warping.sizes());
    for (size_t k = 0; k < layout.cameras.size(); ++k)
    {
        Warping::Warped warped = warping.warp(k);
        if (on_warped)
            on_warped(k, warping, warped);
        correctExposure(*layout.compensator, static_cast<int>(k), warped.corner, warped.image, warped.mask);
        const cv::Mat fed = fedImage(warped.image, deep);
        warped.image.release();
        const cv::Mat mask = cutMask(seams[k], warped.mask);
        seams[k].release();
        blender->feed(fed, mask, warping.corners()[k]);
        progress.show(0.9 * static_cast<double>(k + 1) / static_cast<double>(layout.cameras.size()));
    }
    cv::Mat blended;
    Composition composition;
    blender->blend(blended, composition.shown);
    composition.picture = finished(blended, deep);
    progress.show(1);
    return composition;
}
