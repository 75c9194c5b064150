// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#include "cameras/camera_models.hpp"

#include <algorithm>
#include <opencv2/core/utils/logger.hpp>
#include <opencv2/stitching/detail/motion_estimators.hpp>
#include "cameras/rotation_fit.hpp"
#include "cameras/similarity_fit.hpp"

namespace cv
{
namespace gcpw
{

namespace
{

std::vector<Size> sizesOf(const LinkedImages& images)
{
    std::vector<Size> sizes;
    for (const cv::detail::ImageFeatures& features : images.features)
        sizes.push_back(features.img_size);
    return sizes;
}

/// Cameras with the focal lengths that files note, and those of the others like the median of them, in proportion to their sizes.
std::vector<cv::detail::CameraParams> notedCameras(const LinkedImages& images)
{
    std::vector<double> ratios;
    const auto sideOf = [&](int i)
    { return static_cast<double>(std::max(images.features[i].img_size.width, images.features[i].img_size.height)); };
    for (int i = 0; i < images.count(); ++i)
        if (images.focals[i] > 0)
            ratios.push_back(images.focals[i] / sideOf(i));
    std::nth_element(ratios.begin(), ratios.begin() + ratios.size() / 2, ratios.end());
    const double usual = ratios[ratios.size() / 2];
    std::vector<cv::detail::CameraParams> cameras(images.features.size());
    for (int i = 0; i < images.count(); ++i)
    {
        cameras[i].focal = images.focals[i] > 0 ? images.focals[i] : usual * sideOf(i);
        cameras[i].ppx = 0.5 * images.features[i].img_size.width;
        cameras[i].ppy = 0.5 * images.features[i].img_size.height;
    }
    return cameras;
}

/// @param noted start from the focal lengths that files note, not from those of homographies
bool fitByRay(const LinkedImages& images, double confidence, bool noted, std::vector<cv::detail::CameraParams>& cameras)
{
    if (noted)
        cameras = notedCameras(images);
    cv::detail::HomographyBasedEstimator estimator(noted);
    if (!estimator(images.features, images.matches, cameras))
        return false;
    for (cv::detail::CameraParams& camera : cameras)
    {
        Mat R;
        camera.R.convertTo(R, CV_32F);
        camera.R = R;
    }
    cv::detail::BundleAdjusterRay adjuster;
    adjuster.setConfThresh(confidence);
    return adjuster(images.features, images.matches, cameras);
}

bool fitOneFocal(const LinkedImages& images, double confidence, std::vector<cv::detail::CameraParams>& cameras)
{
    TurningCameras turning;
    if (!fitTurningCameras(sizesOf(images), linksOf(images, confidence), turning))
        return false;
    for (int i = 0; i < images.count(); ++i)
    {
        cameras[i].focal = turning.focal;
        cameras[i].ppx = 0.5 * images.features[i].img_size.width;
        cameras[i].ppy = 0.5 * images.features[i].img_size.height;
        cameras[i].R = Mat(Matx33f(turning.rotations[i]));
    }
    return true;
}

bool fitFlat(const LinkedImages& images, double confidence, std::vector<cv::detail::CameraParams>& cameras)
{
    std::vector<Matx33d> canvas_from_image;
    if (!fitSimilarities(sizesOf(images), linksOf(images, confidence), canvas_from_image))
        return false;
    for (int i = 0; i < images.count(); ++i)
    {
        cameras[i].focal = 1;
        cameras[i].R = Mat(Matx33f(canvas_from_image[i].inv()));
    }
    return true;
}

} // namespace

bool fitCameras(const LinkedImages& images, double confidence, CameraModel model,
                std::vector<cv::detail::CameraParams>& cameras)
{
    cameras.assign(images.features.size(), cv::detail::CameraParams());
    try
    {
        switch (model)
        {
        case CameraModel::TURNING:
            return fitByRay(images, confidence, false, cameras);
        case CameraModel::TURNING_NOTED:
            return notesFocal(images) && fitByRay(images, confidence, true, cameras);
        case CameraModel::TURNING_ONE_FOCAL:
            return fitOneFocal(images, confidence, cameras);
        case CameraModel::FLAT:
            return fitFlat(images, confidence, cameras);
        }
    }
    catch (const cv::Exception& e)
    {
        // OpenCV's adjuster asserts on cameras that exploded.
        CV_LOG_INFO(nullptr, "gcpw: no cameras: " << e.what());
    }
    return false;
}

} // namespace gcpw
} // namespace cv
