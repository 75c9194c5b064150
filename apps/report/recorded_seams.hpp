// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#ifndef GCPW_APPS_REPORT_RECORDED_SEAMS_HPP
#define GCPW_APPS_REPORT_RECORDED_SEAMS_HPP

#include <vector>
#include <opencv2/stitching/detail/seam_finders.hpp>
#include "evaluation/cut.hpp"

namespace report
{

/// A seam finder that keeps what it found: cv::Stitcher does not tell where its cuts run.
class RecordedSeams : public cv::detail::SeamFinder
{
public:
    /// @param finder the one that finds, not empty
    explicit RecordedSeams(const cv::Ptr<cv::detail::SeamFinder>& finder) : finder_(finder) {}

    void find(const std::vector<cv::UMat>& images, const std::vector<cv::Point>& corners,
              std::vector<cv::UMat>& masks) override;

    /// For each image of the last call CV_8UC1, 255 where it is shown, at the resolution of the seams.
    const std::vector<cv::Mat>& parts() const { return parts_; }

    /// Which of as many images, at any other scale, is shown where: the one whose part is the surest.
    evaluation::Labels labelsOf(const std::vector<evaluation::WarpedImage>& images) const;

private:
    cv::Ptr<cv::detail::SeamFinder> finder_;
    std::vector<cv::Mat> parts_;
};

} // namespace report

#endif
