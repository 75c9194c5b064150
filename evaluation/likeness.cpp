// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#include "evaluation/likeness.hpp"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>

namespace evaluation
{

namespace
{

const double FLAT = 2; ///< gray levels: a window with less deviation has no structure

} // namespace

cv::Mat windowMean(const cv::Mat& image)
{
    cv::Mat mean;
    cv::blur(image, mean, cv::Size(LIKENESS_WINDOW, LIKENESS_WINDOW));
    return mean;
}

cv::Mat grayOf(const cv::Mat& bgr)
{
    cv::Mat gray;
    cv::cvtColor(bgr, gray, cv::COLOR_BGR2GRAY);
    gray.convertTo(gray, CV_64F);
    return gray;
}

Shared sharedPart(const WarpedImage& a, const WarpedImage& b)
{
    Shared result;
    result.box = a.place & b.place;
    if (result.box.width < 2 * LIKENESS_WINDOW || result.box.height < 2 * LIKENESS_WINDOW)
        return result;
    const cv::Rect in_a = result.box - a.place.tl();
    const cv::Rect in_b = result.box - b.place.tl();
    result.a = a.corrected(in_a);
    result.b = b.corrected(in_b);
    cv::erode(a.mask(in_a) & b.mask(in_b), result.both, cv::Mat::ones(LIKENESS_WINDOW, LIKENESS_WINDOW, CV_8U),
              cv::Point(-1, -1), 1, cv::BORDER_CONSTANT, cv::Scalar(0));
    return result;
}

Likeness likenessOf(const cv::Mat& a, const cv::Mat& b)
{
    Likeness likeness;
    const cv::Mat mean_a = windowMean(a);
    const cv::Mat mean_b = windowMean(b);
    const cv::Mat var_a = windowMean(a.mul(a)) - mean_a.mul(mean_a);
    const cv::Mat var_b = windowMean(b.mul(b)) - mean_b.mul(mean_b);
    const cv::Mat covariance = windowMean(a.mul(b)) - mean_a.mul(mean_b);
    likeness.structure = cv::Mat(a.size(), CV_64FC1, cv::Scalar(-1));
    likeness.contrast = cv::Mat(a.size(), CV_64FC1, cv::Scalar(0));
    for (int y = 0; y < a.rows; ++y)
        for (int x = 0; x < a.cols; ++x)
        {
            const double va = var_a.at<double>(y, x);
            const double vb = var_b.at<double>(y, x);
            if (!(va > FLAT * FLAT && vb > FLAT * FLAT))
                continue;
            const double zncc = covariance.at<double>(y, x) / std::sqrt(va * vb);
            likeness.structure.at<double>(y, x) = 0.5 * (1 - std::min(std::max(zncc, -1.0), 1.0));
            likeness.contrast.at<double>(y, x) = std::sqrt(std::sqrt(va * vb));
        }
    return likeness;
}

} // namespace evaluation
