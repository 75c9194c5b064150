// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#include "stitch/focal_start.hpp"

bool FocalStart::estimate(const std::vector<cv::detail::ImageFeatures>& features,
                          const std::vector<cv::detail::MatchesInfo>& pairwise_matches,
                          std::vector<cv::detail::CameraParams>& cameras)
{
    bool known = true;
    std::vector<cv::detail::CameraParams> start(features.size());
    for (size_t i = 0; i < features.size(); ++i)
    {
        const auto index = static_cast<size_t>(features[i].img_idx);
        const double focal = index < focals_.size() ? focals_[index] : 0;
        known = known && focal > 0;
        if (!known)
            break;
        start[i].focal = focal * features[i].img_size.width / widths_[index];
        start[i].ppx = 0.5 * features[i].img_size.width;
        start[i].ppy = 0.5 * features[i].img_size.height;
    }
    if (known)
        cameras = start;
    cv::detail::HomographyBasedEstimator estimator(known);
    return estimator(features, pairwise_matches, cameras);
}
