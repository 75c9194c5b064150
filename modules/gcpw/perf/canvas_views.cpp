// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#include "canvas_views.hpp"

#include <cmath>
#include "registration/features_header.hpp"
#include "scene.hpp"

namespace opencv_test
{

namespace
{

const Size VIEW(640, 480);
const int SPACING = 400;   ///< px between neighbours
const double PARALLAX = 3; ///< px, largest displacement in x and in y
const double FADE = 120;   ///< px at the end of a period in which the texture becomes its own beginning

Vec3d colorAt(const Texture& texture, Point2d scene, int period)
{
    if (period == 0)
        return texture.at(scene);
    const double x = scene.x - period * std::floor(scene.x / period);
    const double share = std::max(0.0, 1 - (period - x) / FADE);
    const Vec3d color = texture.at(Point2d(x, scene.y));
    return share == 0 ? color : color * (1 - share) + texture.at(Point2d(x - period, scene.y)) * share;
}

Mat view(int index, Point corner, int period)
{
    const Texture texture(5);
    const double gain = 1 + 0.15 * std::sin(2.0 * index);
    Mat picture(VIEW, CV_8UC3);
    for (int y = 0; y < picture.rows; ++y)
        for (int x = 0; x < picture.cols; ++x)
        {
            const Point2d canvas = corner + Point(x, y);
            const Point2d displacement(PARALLAX * std::sin(canvas.x / 90 + 1.7 * index),
                                       PARALLAX * std::cos(canvas.y / 80 + 1.3 * index));
            picture.at<Vec3b>(y, x) = Vec3b(colorAt(texture, canvas + displacement, period) * gain * 255.0);
        }
    return picture;
}

gcpw::KnownKeypoints keypointsOf(const Mat& image)
{
    const Ptr<SIFT> sift = SIFT::create(2000, 3, 0.01);
    std::vector<KeyPoint> found;
    gcpw::KnownKeypoints keypoints;
    sift->detectAndCompute(image, noArray(), found, keypoints.descriptors);
    KeyPoint::convert(found, keypoints.points);
    return keypoints;
}

} // namespace

CanvasViews::CanvasViews(int count, bool closed)
    : corners(count), images(count), keypoints(count), period(closed ? count * SPACING : 0)
{
    parallel_for_(Range(0, count), [&](const Range& range)
    {
        for (int i = range.start; i < range.end; ++i)
        {
            corners[i] = Point(i * SPACING, i % 2 == 0 ? 0 : 12);
            images[i] = view(i, corners[i], period);
            keypoints[i] = keypointsOf(images[i]);
        }
    });
}

} // namespace opencv_test
