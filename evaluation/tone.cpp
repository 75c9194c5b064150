// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#include "evaluation/tone.hpp"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>

namespace evaluation
{

namespace
{

const int BLOCK = 64;          ///< px
const float COVERED = 0.9F;    ///< least share of a block that its image covers
const uchar DARK = 24;         ///< below it nothing is told apart
const uchar BRIGHT = 250;      ///< above it neither

/// What is summed over the images.
struct Sums
{
    cv::Vec3d change;
    double local = 0;
    double crushed = 0;
    double blown = 0;
    double pixels = 0;
};

cv::Mat inYCrCb(const cv::Mat& bgr)
{
    cv::Mat result;
    cv::cvtColor(bgr, result, cv::COLOR_BGR2YCrCb);
    result.convertTo(result, CV_32F);
    return result;
}

/// The largest change of Cr or Cb of a block, less the image's own.
double localTint(const cv::Mat& change, const cv::Mat& mask, const cv::Vec3d& mean)
{
    cv::Mat weight;
    cv::Mat blocks;
    cv::Mat inside;
    mask.convertTo(inside, CV_32F, 1.0 / 255);
    cv::boxFilter(inside, weight, CV_32F, cv::Size(BLOCK, BLOCK));
    cv::boxFilter(change, blocks, CV_32F, cv::Size(BLOCK, BLOCK));
    double largest = 0;
    for (int y = BLOCK / 2; y < mask.rows; y += BLOCK)
        for (int x = BLOCK / 2; x < mask.cols; x += BLOCK)
            if (weight.at<float>(y, x) > COVERED)
                for (int c : {1, 2})
                    largest = std::max(largest, std::abs(static_cast<double>(blocks.at<cv::Vec3f>(y, x)[c] / weight.at<float>(y, x)) - mean[c]));
    return largest;
}

void add(const WarpedImage& image, Sums& sums)
{
    const int pixels = cv::countNonZero(image.mask);
    if (pixels == 0)
        return;
    cv::Mat change = inYCrCb(image.corrected) - inYCrCb(image.image);
    change.setTo(0, image.mask == 0);
    const cv::Scalar total = cv::sum(change);
    const cv::Vec3d own(total[0], total[1], total[2]);
    sums.local = std::max(sums.local, localTint(change, image.mask, own / pixels));
    sums.change += own;
    sums.pixels += pixels;
    for (int y = 0; y < image.mask.rows; ++y)
        for (int x = 0; x < image.mask.cols; ++x)
        {
            if (!image.mask.at<uchar>(y, x))
                continue;
            const cv::Vec3b& before = image.image.at<cv::Vec3b>(y, x);
            const cv::Vec3b& after = image.corrected.at<cv::Vec3b>(y, x);
            const auto most = [](const cv::Vec3b& p) { return std::max(p[0], std::max(p[1], p[2])); };
            const auto least = [](const cv::Vec3b& p) { return std::min(p[0], std::min(p[1], p[2])); };
            sums.crushed += most(after) < DARK && most(before) >= DARK ? 1 : 0;
            sums.blown += least(after) > BRIGHT && least(before) <= BRIGHT ? 1 : 0;
        }
}

} // namespace

Tone toneOf(const std::vector<WarpedImage>& images)
{
    Sums sums;
    for (const WarpedImage& image : images)
        if (!image.fixed)
            add(image, sums);
    Tone tone;
    if (sums.pixels == 0)
        return tone;
    tone.cast = sums.change / sums.pixels;
    tone.local = sums.local;
    tone.crushed = 100 * sums.crushed / sums.pixels;
    tone.blown = 100 * sums.blown / sums.pixels;
    return tone;
}

} // namespace evaluation
