// This file is part of OpenCV project, under the license terms in its LICENSE file.
//
// A stitching loop written over cv::detail; only what is marked GCPW is not in every such program. All steps work
// on the images as given, best under a megapixel; OpenCV's stitching_detailed has a resolution for each step.
#include <iostream>
#include <opencv2/gcpw.hpp>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/stitching.hpp>

int main(int argc, char** argv)
{
    const auto fail = [](const std::string& why, int code) { std::cerr << why << '\n'; return code; };
    if (argc < 4)
        return fail("detailed IMAGE IMAGE.. PANORAMA", 2);
    std::vector<cv::Mat> images;
    for (int i = 1; i + 1 < argc; ++i)
    {
        images.push_back(cv::imread(argv[i]));
        if (images.back().empty())
            return fail(std::string("cannot read ") + argv[i], 2);
    }

    const cv::Ptr<cv::Stitcher> registration = cv::Stitcher::create(cv::Stitcher::PANORAMA);
    registration->setRegistrationResol(cv::Stitcher::ORIG_RESOL);
    if (registration->estimateTransform(images) != cv::Stitcher::OK)
        return fail("the images do not match", 1);
    const std::vector<cv::detail::CameraParams> cameras = registration->cameras();
    std::vector<cv::Mat> kept; // image k belongs to camera k
    for (int index : registration->component())
        kept.push_back(images[index]);
    // GCPW: meshes and colours of all images together, then a warper and a compensator that know them.
    const cv::Ptr<cv::WarperCreator> base = cv::makePtr<cv::SphericalWarper>();
    const cv::gcpw::Rig rig = cv::gcpw::alignRig(kept, cameras, base);
    const cv::gcpw::GcpwWarper creator(base, rig); // the base warper itself where the rig has no answer
    const cv::Ptr<cv::gcpw::GcpwCompensator> compensator = creator.compensator();
    const cv::Ptr<cv::detail::RotationWarper> warper = creator.create(rig.scale);
    std::vector<cv::Point> corners(kept.size());
    std::vector<cv::UMat> warped(kept.size()), masks(kept.size());
    for (size_t i = 0; i < kept.size(); ++i)
    {
        const cv::Mat_<float> K(cameras[i].K());
        const cv::Mat_<uchar> inside(kept[i].size(), 255);
        corners[i] = warper->warp(kept[i], K, cameras[i].R, cv::INTER_LINEAR, cv::BORDER_REFLECT, warped[i]);
        warper->warp(inside, K, cameras[i].R, cv::INTER_NEAREST, cv::BORDER_CONSTANT, masks[i]);
    }
    compensator->feed(corners, warped, masks);
    for (size_t i = 0; i < kept.size(); ++i)
        compensator->apply(static_cast<int>(i), corners[i], warped[i], masks[i]);
    cv::gcpw::GcpwSeamFinder().find(warped, corners, masks);
    cv::detail::MultiBandBlender blender;
    blender.prepare(cv::detail::resultRoi(corners, warped));
    for (size_t i = 0; i < kept.size(); ++i)
        blender.feed(warped[i], masks[i], corners[i]);
    cv::Mat panorama, mask;
    blender.blend(panorama, mask);
    if (!cv::imwrite(argv[argc - 1], cv::Mat_<cv::Vec3b>(panorama)))
        return fail(std::string("cannot write ") + argv[argc - 1], 2);
    return 0;
}
