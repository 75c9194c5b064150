// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#include "evaluation/cut.hpp"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>
#include <opencv2/stitching/detail/seam_finders.hpp>

namespace evaluation
{

namespace
{

Labels emptyLabels(const std::vector<WarpedImage>& images)
{
    const cv::Rect canvas = canvasOf(images);
    return {canvas.tl(), cv::Mat(canvas.size(), CV_16SC1, cv::Scalar(-1))};
}

} // namespace

Labels graphCut(const std::vector<WarpedImage>& images, double pixels)
{
    double largest = 0;
    for (const WarpedImage& image : images)
        largest = std::max(largest, static_cast<double>(image.place.area()));
    const double scale = std::min(1.0, std::sqrt(pixels / largest));
    std::vector<cv::UMat> small;
    std::vector<cv::UMat> parts;
    std::vector<cv::Point> corners;
    for (const WarpedImage& image : images)
    {
        cv::Mat picture;
        cv::Mat mask;
        cv::resize(image.corrected, picture, cv::Size(), scale, scale, cv::INTER_AREA);
        cv::resize(image.mask, mask, picture.size(), 0, 0, cv::INTER_AREA);
        picture.convertTo(picture, CV_32F);
        mask = mask == 255;
        small.emplace_back();
        parts.emplace_back();
        picture.copyTo(small.back());
        mask.copyTo(parts.back());
        corners.emplace_back(cvRound(image.place.x * scale), cvRound(image.place.y * scale));
    }
    cv::detail::GraphCutSeamFinder(cv::detail::GraphCutSeamFinderBase::COST_COLOR_GRAD).find(small, corners, parts);
    Labels labels = emptyLabels(images);
    for (size_t k = 0; k < images.size(); ++k)
    {
        cv::Mat part;
        cv::resize(parts[k].getMat(cv::ACCESS_READ), part, images[k].place.size(), 0, 0, cv::INTER_LINEAR);
        part = (part > 127) & images[k].mask;
        labels.of(images[k].place - labels.origin).setTo(cv::Scalar(static_cast<double>(k)), part);
    }
    return labels;
}

std::vector<cv::Point> cutPixels(const cv::Mat& labels, const cv::Mat& valid, int i, int j)
{
    std::vector<cv::Point> pixels;
    const auto parted = [&](short p, short q) { return (p == i && q == j) || (p == j && q == i); };
    for (int y = 0; y < labels.rows; ++y)
        for (int x = 0; x < labels.cols; ++x)
        {
            const short own = labels.at<short>(y, x);
            const bool right = x + 1 < labels.cols && parted(own, labels.at<short>(y, x + 1));
            const bool below = y + 1 < labels.rows && parted(own, labels.at<short>(y + 1, x));
            if ((right || below) && valid.at<uchar>(y, x))
                pixels.emplace_back(x, y);
        }
    return pixels;
}

} // namespace evaluation
