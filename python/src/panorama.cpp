// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#include "panorama.hpp"

#include <cmath>
#include <numeric>
#include <opencv2/gcpw.hpp>
#include <opencv2/imgproc.hpp>
#include "arrays.hpp"

using namespace cv::gcpw;

namespace
{

std::vector<cv::Mat> bgrPictures(const std::vector<cv::Mat>& photographs)
{
    std::vector<cv::Mat> images;
    for (size_t i = 0; i < photographs.size(); ++i)
        images.push_back(bgrOf(photographs[i], i));
    return images;
}

/// Throws cv::Exception that names a photograph which is not of the size that camera `index` of the rig was made with.
void checkSize(const Rig& rig, size_t index, cv::Size size, int photograph)
{
    if (rig.image_sizes.size() != rig.cameras.size())
        return; // not known
    const cv::Size made = rig.image_sizes[index];
    // The rig has the size at its work scale, rounded.
    if (std::abs(size.width * rig.work_scale - made.width) > 1 || std::abs(size.height * rig.work_scale - made.height) > 1)
        CV_Error(cv::Error::StsUnmatchedSizes, cv::format("photograph %d is %d x %d px, and the rig was made with one of about %.0f x %.0f px; resize it",
                                                          photograph + 1, size.width, size.height, made.width / rig.work_scale, made.height / rig.work_scale));
}

/// Which of the photographs belong to the cameras of a rig. Throws cv::Exception that names what does not fit.
std::vector<int> componentOf(const Rig& rig, const std::vector<cv::Mat>& photographs)
{
    std::vector<int> component = rig.component;
    if (component.empty() && rig.cameras.size() == photographs.size())
    {
        component.resize(photographs.size());
        std::iota(component.begin(), component.end(), 0);
    }
    if (component.empty() || component.size() != rig.cameras.size())
        CV_Error(cv::Error::StsUnmatchedSizes, cv::format("%zu photographs are given; the rig has %zu cameras, and wants one for each",
                                                          photographs.size(), rig.cameras.size()));
    for (size_t i = 0; i < component.size(); ++i)
    {
        const int k = component[i];
        if (k < 0 || k >= static_cast<int>(photographs.size()))
            CV_Error(cv::Error::StsOutOfRange, cv::format("the rig wants photograph %d, and %zu are given; give all of the first time, in that order",
                                                          k + 1, photographs.size()));
        checkSize(rig, i, photographs[k].size(), k);
    }
    return component;
}

/// Composes the picture of cameras and a rig that are known.
Panorama compose(const Rig& rig, const std::string& projection, const std::vector<cv::detail::CameraParams>& cameras,
                 const std::vector<int>& component, const std::vector<cv::Mat>& images, double megapix, const Params& params, Watch& watch)
{
    watch.tell("render", 0);
    CameraEstimate estimate;
    estimate.projection = projection;
    const cv::Ptr<cv::Stitcher> stitcher = cv::Stitcher::create(cv::Stitcher::PANORAMA);
    // The stitcher computes its work scale from the size of the first photograph; the rig has its own.
    const double pixels = static_cast<double>(images[0].total());
    stitcher->setRegistrationResol(rig.work_scale < 1 ? rig.work_scale * rig.work_scale * pixels * 1e-6 : cv::Stitcher::ORIG_RESOL);
    stitcher->setCompositingResol(megapix > 0 ? megapix : cv::Stitcher::ORIG_RESOL);
    stitcher->setWarper(estimate.warper());
    const cv::Ptr<StitcherBinding> binding = attach(stitcher, params);
    binding->setRig(rig);
    Panorama made;
    cv::Stitcher::Status status = stitcher->setTransform(images, cameras, component);
    if (status == cv::Stitcher::OK)
        status = stitcher->composePanorama(made.picture);
    if (status != cv::Stitcher::OK)
        throw NoAlignment(explain(status));
    stitcher->resultMask().copyTo(made.mask);
    made.mask.setTo(255, made.mask);
    if (rig.turned)
    {
        cv::rotate(made.picture, made.picture, cv::ROTATE_90_CLOCKWISE);
        cv::rotate(made.mask, made.mask, cv::ROTATE_90_CLOCKWISE);
    }
    made.rig = rig;
    made.used = component;
    watch.tell("render", 1);
    return made;
}

} // namespace

Panorama stitchPhotographs(const std::vector<cv::Mat>& photographs, const Params& params, const std::string& projection, double megapix,
                           Watch& watch)
{
    if (photographs.size() < 2)
        CV_Error(cv::Error::StsBadArg, cv::format("two photographs or more are needed; %zu given", photographs.size()));
    params.check();
    const std::vector<cv::Mat> images = bgrPictures(photographs);
    CameraOptions options;
    options.workMegapix = params.workMegapix;
    options.projection = projection;
    const CameraEstimate estimate = estimateCameras(images, options, watch.progress());
    watch.tell("cameras", 1);
    if (!estimate.ok())
        throw NoAlignment(estimate.decisions.empty() ? explain(cv::Stitcher::ERR_NEED_MORE_IMGS) : estimate.decisions.back());
    const Rig rig = alignRig(estimate, params, watch.progress());
    Panorama made = compose(rig, estimate.projection, estimate.cameras, estimate.component, images, megapix, params, watch);
    made.decisions = estimate.decisions;
    if (!rig.alignment.report().message.empty())
        made.decisions.push_back(rig.alignment.report().message);
    return made;
}

Panorama stitchByRig(const Rig& rig, const std::vector<cv::Mat>& photographs, double megapix, Watch& watch)
{
    if (!rig.usable())
    {
        rig.check();
        CV_Error(cv::Error::StsBadArg, "the rig is not usable: " + rig.alignment.report().message + "; estimate it again with gcpw.stitch()");
    }
    if (rig.projection.empty())
        CV_Error(cv::Error::StsBadArg, "the rig does not know its projection; estimate it again with gcpw.stitch() or gcpw.align_rig()");
    const std::vector<cv::Mat> images = bgrPictures(photographs);
    const std::vector<int> component = componentOf(rig, images);
    return compose(rig, rig.projection, rig.cameras, component, images, megapix, Params(), watch);
}

Warped warpByRig(const Rig& rig, int index, const cv::Mat& photograph)
{
    rig.check();
    if (index < 0 || index >= static_cast<int>(rig.cameras.size()))
        CV_Error(cv::Error::StsOutOfRange, cv::format("there is no camera %d; the rig has %zu", index, rig.cameras.size()));
    if (rig.projection.empty())
        CV_Error(cv::Error::StsBadArg, "the rig does not know its projection; use gcpw.Warper(projection, scale, rig)");
    checkSize(rig, index, photograph.size(), index);
    const cv::detail::CameraParams& camera = rig.cameras[index];
    cv::Mat K;
    camera.K().convertTo(K, CV_32F);
    K.rowRange(0, 2) *= 1 / rig.work_scale;
    PyGcpwWarper warper(rig.projection, static_cast<float>(rig.scale / rig.work_scale), rig);
    Warped warped;
    warped.corner = warper.warp(photograph, K, camera.R, cv::INTER_LINEAR, cv::BORDER_REFLECT, warped.picture);
    warper.warp(cv::Mat(photograph.size(), CV_8UC1, cv::Scalar(255)), K, camera.R, cv::INTER_NEAREST, cv::BORDER_CONSTANT, warped.mask);
    return warped;
}
