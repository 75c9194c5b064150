// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#include "common/deep_exposure.hpp"

#include <opencv2/gcpw/compensator.hpp>
#include <opencv2/imgproc.hpp>

void correctExposure(cv::detail::ExposureCompensator& compensator, int index, cv::Point corner, cv::Mat& image,
                     const cv::Mat& mask)
{
    if (image.depth() == CV_8U || dynamic_cast<cv::gcpw::GcpwCompensator*>(&compensator))
    {
        compensator.apply(index, corner, image, mask);
        return;
    }
    std::vector<cv::Mat> gains;
    compensator.getMatGains(gains);
    if (index >= static_cast<int>(gains.size())) // of cv::detail::NoExposureCompensator there are none
        return;
    const cv::Mat& gain = gains[static_cast<size_t>(index)];
    const bool whole = gain.depth() == CV_64F; // one number, or one for each channel
    if (whole)
    {
        const double* const numbers = gain.ptr<double>();
        const bool one = gain.total() == 1;
        cv::multiply(image, one ? cv::Scalar::all(numbers[0]) : cv::Scalar(numbers[0], numbers[1], numbers[2]), image);
        return;
    }
    cv::Mat map; // of blocks, with one channel or three
    cv::resize(gain, map, image.size(), 0, 0, cv::INTER_LINEAR);
    if (map.channels() == 1)
        cv::merge(std::vector<cv::Mat>{map, map, map}, map);
    cv::multiply(image, map, image, 1, image.type());
}
