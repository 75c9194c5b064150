// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#include "report/warped_photographs.hpp"

#include <opencv2/imgproc.hpp>
#include "common/read_photograph.hpp"

namespace report
{

double warperScale(const Cameras& cameras, double scale)
{
    return cameras.focal * scale / cameras.work_scale;
}

std::vector<evaluation::WarpedImage> warpedPhotographs(const Cameras& cameras, cv::WarperCreator& creator,
                                                       cv::detail::ExposureCompensator& compensator, double scale)
{
    const double aspect = scale / cameras.work_scale;
    const cv::Ptr<cv::detail::RotationWarper> warper = creator.create(static_cast<float>(warperScale(cameras, scale)));
    std::vector<evaluation::WarpedImage> warped;
    for (size_t k = 0; k < cameras.cameras.size(); ++k)
    {
        cv::Mat photograph = cameras.photographs[static_cast<size_t>(cameras.component[k])];
        if (scale < 1)
            cv::resize(photograph, photograph, cv::Size(), scale, scale, cv::INTER_AREA);
        cv::Mat mask = shownPixels(photograph);
        if (mask.empty())
            mask = cv::Mat(photograph.size(), CV_8UC1, cv::Scalar(255));
        cv::detail::CameraParams camera = cameras.cameras[k];
        camera.focal *= aspect;
        camera.ppx *= aspect;
        camera.ppy *= aspect;
        cv::Mat K;
        camera.K().convertTo(K, CV_32F);
        evaluation::WarpedImage item;
        const cv::Point corner =
            warper->warp(withoutAlpha(photograph), K, camera.R, cv::INTER_LINEAR, cv::BORDER_REFLECT, item.image);
        warper->warp(mask == 255, K, camera.R, cv::INTER_NEAREST, cv::BORDER_CONSTANT, item.mask);
        item.place = cv::Rect(corner, item.image.size());
        item.corrected = item.image.clone();
        compensator.apply(static_cast<int>(k), corner, item.corrected, item.mask);
        warped.push_back(item);
    }
    return warped;
}

} // namespace report
