// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#include "report/recorded_seams.hpp"

#include <opencv2/imgproc.hpp>

namespace report
{

void RecordedSeams::find(const std::vector<cv::UMat>& images, const std::vector<cv::Point>& corners,
                         std::vector<cv::UMat>& masks)
{
    finder_->find(images, corners, masks);
    parts_.clear();
    for (const cv::UMat& mask : masks)
        parts_.push_back(mask.getMat(cv::ACCESS_READ).clone());
}

evaluation::Labels RecordedSeams::labelsOf(const std::vector<evaluation::WarpedImage>& images) const
{
    CV_CheckEQ(images.size(), parts_.size(), "as many images as the seams were found for");
    const cv::Rect canvas = evaluation::canvasOf(images);
    evaluation::Labels labels = {canvas.tl(), cv::Mat(canvas.size(), CV_16SC1, cv::Scalar(-1))};
    cv::Mat surest(canvas.size(), CV_8UC1, cv::Scalar(0));
    for (size_t k = 0; k < images.size(); ++k)
    {
        const cv::Rect there = images[k].place - canvas.tl();
        cv::Mat part;
        cv::dilate(parts_[k], part, cv::Mat()); // as cv::Stitcher does, so that no pixel is nobody's
        cv::blur(part, part, cv::Size(3, 3));
        cv::resize(part, part, there.size(), 0, 0, cv::INTER_LINEAR);
        const cv::Mat better = (part > surest(there)) & images[k].mask;
        labels.of(there).setTo(cv::Scalar(static_cast<double>(k)), better);
        part.copyTo(surest(there), better);
    }
    return labels;
}

} // namespace report
