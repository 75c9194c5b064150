// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#include "common/synthetic_pair.hpp"

#include <cmath>
#include <opencv2/imgproc.hpp>

namespace
{

const cv::Size SIZE(800, 600);
const int WIDE = 1200;        ///< px: the scene is wider than a picture
const int MARGIN = 40;        ///< px around it, so that parallax never looks past its edge
const double SHIFT = 320;     ///< px between the two views
const double PARALLAX = 9;    ///< px between near and far

/// A street of house fronts: coloured boxes with windows, over a sky.
cv::Mat paintScene()
{
    cv::RNG random(20);
    cv::Mat scene(SIZE.height + 2 * MARGIN, WIDE + 2 * MARGIN, CV_8UC3);
    for (int y = 0; y < scene.rows; ++y)
    {
        const cv::Point3i sky(220 - y / 8, 190 - y / 8, 150 + y / 12);
        scene.row(y).setTo(cv::Scalar(sky.x, sky.y, sky.z));
    }
    for (int left = 0; left < scene.cols;)
    {
        const int width = random.uniform(90, 170);
        const int top = random.uniform(80, 260);
        const cv::Scalar wall(random.uniform(60, 200), random.uniform(60, 200), random.uniform(60, 200));
        cv::rectangle(scene, cv::Rect(left, top, width, scene.rows - top), wall, cv::FILLED);
        for (int y = top + 18; y < scene.rows - 40; y += 44)
            for (int x = left + 12; x + 20 < left + width; x += 34)
            {
                const cv::Scalar glass(random.uniform(20, 240), random.uniform(20, 240), random.uniform(20, 240));
                cv::rectangle(scene, cv::Rect(x, y, 20, 28), glass, cv::FILLED);
                cv::line(scene, cv::Point(x, y + 14), cv::Point(x + 19, y + 14), wall * 0.6, 2, cv::LINE_AA);
            }
        left += width;
    }
    cv::Mat grain(scene.size(), CV_8UC3);
    random.fill(grain, cv::RNG::UNIFORM, 0, 40);
    cv::GaussianBlur(grain, grain, cv::Size(), 1.2);
    cv::Mat result;
    cv::add(scene, grain, result);
    cv::GaussianBlur(result, result, cv::Size(), 0.8);
    return result;
}

/// One view of the scene; nearness varies smoothly over it and shifts it by up to PARALLAX.
cv::Mat view(const cv::Mat& scene, double left, double parallax)
{
    cv::Mat map(SIZE, CV_32FC2);
    for (int y = 0; y < SIZE.height; ++y)
        for (int x = 0; x < SIZE.width; ++x)
        {
            const double nearness = 0.5 + 0.5 * std::sin((left + x) / 110.0) * std::cos(y / 140.0);
            map.at<cv::Vec2f>(y, x) = cv::Vec2f(static_cast<float>(MARGIN + left + x + parallax * nearness),
                                                static_cast<float>(MARGIN + y + 0.2 * parallax * nearness));
        }
    cv::Mat picture;
    cv::remap(scene, picture, map, cv::noArray(), cv::INTER_CUBIC, cv::BORDER_REFLECT);
    return picture;
}

/// Darker and warmer, and more so towards the right.
void changeExposure(cv::Mat& picture)
{
    for (int y = 0; y < picture.rows; ++y)
        for (int x = 0; x < picture.cols; ++x)
        {
            const double fade = 0.85 - 0.25 * x / picture.cols;
            cv::Vec3b& p = picture.at<cv::Vec3b>(y, x);
            p = cv::Vec3b(cv::saturate_cast<uchar>(0.85 * fade * p[0]), cv::saturate_cast<uchar>(fade * p[1] + 4),
                          cv::saturate_cast<uchar>(1.05 * fade * p[2] + 10));
        }
}

} // namespace

void makeSyntheticPair(cv::Mat& source, cv::Mat& target)
{
    const cv::Mat scene = paintScene();
    source = view(scene, 0, PARALLAX);
    target = view(scene, SHIFT, 0);
    changeExposure(source);
}
