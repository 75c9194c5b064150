// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#ifndef GCPW_APPS_FOCAL_START_HPP
#define GCPW_APPS_FOCAL_START_HPP

#include <vector>
#include <opencv2/stitching/detail/motion_estimators.hpp>

/** @brief cv::detail::HomographyBasedEstimator that starts from the focal lengths that the photographs' files note.

Where one of the photographs has none, all are estimated from the matches. */
class FocalStart : public cv::detail::Estimator
{
public:
    /** @param focals of all photographs, px; 0 where a file says none  @param widths of the photographs, px */
    FocalStart(const std::vector<double>& focals, const std::vector<int>& widths) : focals_(focals), widths_(widths) {}

protected:
    bool estimate(const std::vector<cv::detail::ImageFeatures>& features,
                  const std::vector<cv::detail::MatchesInfo>& pairwise_matches,
                  std::vector<cv::detail::CameraParams>& cameras) override;

private:
    std::vector<double> focals_;
    std::vector<int> widths_;
};

#endif
