// Part of the GCPW module for OpenCV. Licence: Apache-2.0 (see LICENSE).
//
// A stitching loop of one's own over cv::detail, as in OpenCV's stitching_detailed, with GCPW in it. Everything but the
// steps marked GCPW is what such a program does anyway.
#include <algorithm>
#include <cmath>
#include <iostream>
#include <opencv2/gcpw.hpp>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>
#include <opencv2/stitching/detail/blenders.hpp>
#include <opencv2/stitching/detail/matchers.hpp>
#include <opencv2/stitching/detail/motion_estimators.hpp>
#include <opencv2/stitching/detail/seam_finders.hpp>
#include <opencv2/stitching/detail/util.hpp>
#include <opencv2/stitching/warpers.hpp>

namespace
{

typedef std::vector<cv::detail::CameraParams> Cameras;

const double WORK_MEGAPIX = 0.6; ///< features, cameras and the alignment
const double SEAM_MEGAPIX = 0.1; ///< seams
const float CONFIDENCE = 1;      ///< that two images belong together

std::vector<cv::Mat> scaled(const std::vector<cv::Mat>& images, double scale)
{
    std::vector<cv::Mat> result(images.size());
    for (size_t i = 0; i < images.size(); ++i)
        cv::resize(images[i], result[i], cv::Size(), scale, scale, cv::INTER_LINEAR_EXACT);
    return result;
}

cv::Mat intrinsics(const cv::detail::CameraParams& camera, double scale)
{
    cv::detail::CameraParams at_scale = camera;
    at_scale.focal *= scale;
    at_scale.ppx *= scale;
    at_scale.ppy *= scale;
    cv::Mat K;
    at_scale.K().convertTo(K, CV_32F);
    return K;
}

/// Registration: keypoints, matches, the images that belong together, cameras. False if no two of them do.
bool findCameras(const std::vector<cv::Mat>& images, std::vector<int>& kept, Cameras& cameras)
{
    std::vector<cv::detail::ImageFeatures> features;
    cv::detail::computeImageFeatures(cv::SIFT::create(3000, 3, 0.01), images, features);
    std::vector<cv::detail::MatchesInfo> matches;
    cv::detail::BestOf2NearestMatcher matcher(false, 0.65F);
    matcher(features, matches);
    kept = cv::detail::leaveBiggestComponent(features, matches, CONFIDENCE);
    if (kept.size() < 2 || !cv::detail::HomographyBasedEstimator()(features, matches, cameras))
        return false;
    for (cv::detail::CameraParams& camera : cameras)
        camera.R.convertTo(camera.R, CV_32F);
    cv::detail::BundleAdjusterRay adjuster;
    adjuster.setConfThresh(CONFIDENCE);
    if (!adjuster(features, matches, cameras))
        return false;
    std::vector<cv::Mat> rotations;
    for (const cv::detail::CameraParams& camera : cameras)
        rotations.push_back(camera.R);
    cv::detail::waveCorrect(rotations, cv::detail::WAVE_CORRECT_HORIZ); // changes the cameras' own R
    return true;
}

/// The images on the canvas of one warper.
struct Warped
{
    std::vector<cv::Point> corners;
    std::vector<cv::Size> sizes;
    std::vector<cv::UMat> images;
    std::vector<cv::UMat> masks;
};

/// @param scale px of the images per px of the cameras
Warped warpAll(const std::vector<cv::Mat>& images, const Cameras& cameras, double scale, cv::detail::RotationWarper& warper)
{
    Warped warped;
    warped.images.resize(images.size());
    warped.masks.resize(images.size());
    for (size_t i = 0; i < images.size(); ++i)
    {
        const cv::Mat K = intrinsics(cameras[i], scale);
        const cv::Mat inside(images[i].size(), CV_8UC1, cv::Scalar(255));
        warped.corners.push_back(
            warper.warp(images[i], K, cameras[i].R, cv::INTER_LINEAR, cv::BORDER_REFLECT, warped.images[i]));
        warper.warp(inside, K, cameras[i].R, cv::INTER_NEAREST, cv::BORDER_CONSTANT, warped.masks[i]);
        warped.sizes.push_back(warped.images[i].size());
    }
    return warped;
}

/// Colours and seams at low resolution. Returns the masks cut along the seams.
std::vector<cv::UMat> findSeams(Warped warped, cv::gcpw::GcpwCompensator& compensator)
{
    compensator.feed(warped.corners, warped.images, warped.masks);
    std::vector<cv::UMat> floats(warped.images.size());
    for (size_t i = 0; i < warped.images.size(); ++i)
    {
        compensator.apply(static_cast<int>(i), warped.corners[i], warped.images[i], warped.masks[i]);
        warped.images[i].convertTo(floats[i], CV_32F);
    }
    cv::detail::GraphCutSeamFinder(cv::detail::GraphCutSeamFinderBase::COST_COLOR).find(floats, warped.corners, warped.masks);
    return warped.masks;
}

cv::Mat compose(const Warped& warped, const std::vector<cv::UMat>& seams, cv::gcpw::GcpwCompensator& compensator)
{
    cv::detail::MultiBandBlender blender;
    blender.prepare(cv::detail::resultRoi(warped.corners, warped.sizes));
    for (size_t i = 0; i < warped.images.size(); ++i)
    {
        compensator.apply(static_cast<int>(i), warped.corners[i], warped.images[i], warped.masks[i]);
        cv::Mat image;
        warped.images[i].convertTo(image, CV_16S);
        cv::Mat seam;
        cv::dilate(seams[i], seam, cv::noArray());
        cv::resize(seam, seam, warped.sizes[i], 0, 0, cv::INTER_LINEAR_EXACT);
        cv::bitwise_and(seam, warped.masks[i], seam);
        blender.feed(image, seam, warped.corners[i]);
    }
    cv::Mat panorama;
    cv::Mat mask;
    blender.blend(panorama, mask);
    panorama.convertTo(panorama, CV_8U);
    return panorama;
}

int stitch(std::vector<cv::Mat> images, const std::string& path)
{
    const double pixels = static_cast<double>(images[0].total());
    const double work_scale = std::min(1.0, std::sqrt(WORK_MEGAPIX * 1e6 / pixels));
    const double seam_scale = std::min(1.0, std::sqrt(SEAM_MEGAPIX * 1e6 / pixels));
    std::vector<int> kept;
    Cameras cameras;
    if (!findCameras(scaled(images, work_scale), kept, cameras))
    {
        std::cerr << "gcpw_detailed: the images do not match\n";
        return 1;
    }
    std::vector<cv::Mat> subset;
    for (int index : kept)
        subset.push_back(images[static_cast<size_t>(index)]);
    images.swap(subset);

    // GCPW, step 1: with the cameras known, estimate meshes and colours of all images together.
    const cv::Ptr<cv::WarperCreator> base = cv::makePtr<cv::SphericalWarper>();
    const cv::gcpw::Rig rig = cv::gcpw::alignRig(scaled(images, work_scale), cameras, base);
    std::cout << (rig.usable() ? "refined" : rig.alignment.report().message) << '\n';

    // GCPW, step 2: a warper and a compensator that know them, at whatever scale. A rig without an answer gives the base warper.
    const cv::gcpw::GcpwWarper creator(base, rig);
    const cv::Ptr<cv::gcpw::GcpwCompensator> compensator = creator.compensator();

    const double to_seam = seam_scale / work_scale;
    const cv::Ptr<cv::detail::RotationWarper> small = creator.create(static_cast<float>(rig.scale * to_seam));
    const std::vector<cv::UMat> seams = findSeams(warpAll(scaled(images, seam_scale), cameras, to_seam, *small), *compensator);
    const cv::Ptr<cv::detail::RotationWarper> full = creator.create(static_cast<float>(rig.scale / work_scale));
    const cv::Mat panorama = compose(warpAll(images, cameras, 1 / work_scale, *full), seams, *compensator);
    if (!cv::imwrite(path, panorama))
    {
        std::cerr << "gcpw_detailed: cannot write " << path << '\n';
        return 2;
    }
    return 0;
}

} // namespace

int main(int argc, char** argv)
{
    std::vector<cv::Mat> images;
    for (int i = 1; i + 1 < argc; ++i)
        images.push_back(cv::imread(argv[i]));
    if (images.size() < 2)
    {
        std::cerr << "gcpw_detailed IMAGE IMAGE.. PANORAMA\n";
        return 2;
    }
    for (size_t i = 0; i < images.size(); ++i)
        if (images[i].empty())
        {
            std::cerr << "gcpw_detailed: cannot read " << argv[i + 1] << '\n';
            return 2;
        }
    try
    {
        return stitch(images, argv[argc - 1]);
    }
    catch (const cv::Exception& e)
    {
        std::cerr << "gcpw_detailed: " << e.what() << '\n';
        return 2;
    }
}
