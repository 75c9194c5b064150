// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#include "report/maps.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <opencv2/imgproc.hpp>
#include "evaluation/likeness.hpp"

namespace report
{

namespace
{

using evaluation::WarpedImage;

const float GRAY_LIGHT = 0.55F; ///< of the picture under a map: the map is what is looked at
const float STRONGEST = 0.9F;   ///< opacity of a map

/// A place on a scale of colours, BGR.
struct Stop
{
    float at;
    cv::Vec3f color;
};

const std::vector<Stop> HEAT = {{0.0F, {60, 220, 255}}, {0.45F, {40, 90, 250}}, {1.0F, {150, 0, 190}}};
const cv::Vec3f LIGHTER(30, 140, 255);
const cv::Vec3f DARKER(255, 130, 40);

cv::Vec3f colorAt(const std::vector<Stop>& scale, float value)
{
    for (size_t k = 1; k < scale.size(); ++k)
        if (value <= scale[k].at)
        {
            const float part = (value - scale[k - 1].at) / (scale[k].at - scale[k - 1].at);
            return (1 - part) * scale[k - 1].color + part * scale[k].color;
        }
    return scale.back().color;
}

cv::Mat dimmed(const cv::Mat& picture)
{
    cv::Mat gray;
    cv::Mat result;
    cv::cvtColor(picture, gray, cv::COLOR_BGR2GRAY);
    cv::cvtColor(gray, result, cv::COLOR_GRAY2BGR);
    result.convertTo(result, CV_8U, GRAY_LIGHT);
    return result;
}

void lay(const cv::Vec3f& color, float opacity, cv::Vec3b& pixel)
{
    for (int c = 0; c < 3; ++c)
        pixel[c] = cv::saturate_cast<uchar>((1 - opacity) * static_cast<float>(pixel[c]) + opacity * color[c]);
}

cv::Mat lightOf(const cv::Mat& bgr)
{
    cv::Mat light;
    cv::cvtColor(bgr, light, cv::COLOR_BGR2GRAY);
    light.convertTo(light, CV_32F);
    return light;
}

} // namespace

Misalignment misalignmentOf(const std::vector<WarpedImage>& images, const cv::Rect& frame)
{
    cv::Mat sum(frame.size(), CV_32FC1, cv::Scalar(0));
    cv::Mat count(frame.size(), CV_32FC1, cv::Scalar(0));
    for (size_t i = 0; i < images.size(); ++i)
        for (size_t j = i + 1; j < images.size(); ++j)
        {
            const evaluation::Shared shared = evaluation::sharedPart(images[i], images[j]);
            const cv::Rect common = shared.box & frame;
            if (shared.both.empty() || common.empty())
                continue;
            const cv::Rect inside = common - shared.box.tl();
            const cv::Mat structure =
                evaluation::likenessOf(evaluation::grayOf(shared.a), evaluation::grayOf(shared.b)).structure(inside);
            const cv::Mat known = (structure >= 0) & shared.both(inside);
            cv::Mat part = sum(common - frame.tl());
            cv::Mat counted = count(common - frame.tl());
            cv::add(part, structure, part, known, CV_32F);
            cv::add(counted, cv::Scalar(1), counted, known);
        }
    Misalignment result;
    cv::divide(sum, count, result.unlikeness);
    result.unlikeness.setTo(-1, count == 0);
    const int compared = cv::countNonZero(count);
    result.share = compared > 0 ? 100.0 * cv::countNonZero(result.unlikeness > DOUBLE) / compared
                                : std::numeric_limits<double>::quiet_NaN();
    return result;
}

cv::Mat drawn(const Misalignment& misalignment, const cv::Mat& picture)
{
    const float first = static_cast<float>(0.5 * DOUBLE);
    const float last = 0.5F; // no correlation at all
    cv::Mat result = dimmed(picture);
    for (int y = 0; y < result.rows; ++y)
        for (int x = 0; x < result.cols; ++x)
        {
            const float value = std::min((misalignment.unlikeness.at<float>(y, x) - first) / (last - first), 1.0F);
            if (value > 0)
                lay(colorAt(HEAT, value), STRONGEST * std::min(1.0F, 0.35F + 2 * value), result.at<cv::Vec3b>(y, x));
        }
    return result;
}

cv::Mat drawnLight(const Picture& picture, const cv::Mat& framed_image, const cv::Rect& frame)
{
    cv::Mat result = dimmed(framed_image);
    for (size_t k = 0; k < picture.images.size(); ++k)
    {
        const WarpedImage& image = picture.images[k];
        const cv::Rect common = image.place & frame;
        if (common.empty())
            continue;
        const cv::Rect inside = common - image.place.tl();
        cv::Mat seen = image.mask(inside).clone();
        if (!picture.labels.of.empty())
            seen &= picture.labels.of(common - picture.labels.origin) == static_cast<double>(k);
        const cv::Mat change = lightOf(image.corrected(inside)) - lightOf(image.image(inside));
        cv::Mat part = result(common - frame.tl());
        for (int y = 0; y < part.rows; ++y)
            for (int x = 0; x < part.cols; ++x)
                if (seen.at<uchar>(y, x))
                {
                    const float value = change.at<float>(y, x) / static_cast<float>(STRONG_LIGHT);
                    lay(value > 0 ? LIGHTER : DARKER, STRONGEST * std::min(std::abs(value), 1.0F),
                        part.at<cv::Vec3b>(y, x));
                }
    }
    return result;
}

} // namespace report
