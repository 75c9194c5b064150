// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#include "stitching/seam_rotation.hpp"

#include <cmath>

namespace cv
{
namespace gcpw
{

namespace
{

/// Distance of two canvas positions that repeat, in -period/2 .. period/2.
double wrapped(double distance, double period)
{
    return distance - period * std::round(distance / period);
}

} // namespace

Matx33f rotatedAboutAxis(const Matx33f& R, double radians)
{
    if (radians == 0)
        return R;
    const double c = std::cos(radians);
    const double s = std::sin(radians);
    return Matx33f(Matx33d(c, 0, s, 0, 1, 0, -s, 0, c) * Matx33d(R));
}

double periodOf(cv::detail::RotationWarper& warper, Size image, const Mat& K, const Matx33f& R)
{
    const double period = 2 * CV_PI * warper.getScale();
    const double tolerance = 1e-3 * period;
    const Point2f points[] = {Point2f(0.5F * image.width, 0.5F * image.height), Point2f(0.3F * image.width, 0.6F * image.height)};
    for (const double radians : {0.3, -0.2})
        for (const Point2f& p : points)
        {
            const Point2d before = warper.warpPoint(p, K, Mat(R));
            const Point2d after = warper.warpPoint(p, K, Mat(rotatedAboutAxis(R, radians)));
            const double shift = wrapped(after.x - before.x - radians * warper.getScale(), period);
            if (!(std::abs(shift) < tolerance) || !(std::abs(after.y - before.y) < tolerance))
                return 0;
        }
    return period;
}

double rotateOffSeam(cv::detail::RotationWarper& warper, Size image, const Mat& K, const Matx33f& R, double period)
{
    if (period <= 0)
        return 0;
    const Rect plain = warper.warpRoi(image, K, Mat(R));
    if (plain.width < 0.9 * period)
        return 0;
    const Point2f centre(0.5F * image.width, 0.5F * image.height);
    const double scale = warper.getScale();
    const double seam_rotation_rad = std::round(warper.warpPoint(centre, K, Mat(R)).x) / scale;
    const Rect moved = warper.warpRoi(image, K, Mat(rotatedAboutAxis(R, -seam_rotation_rad)));
    // An image that spans the canvas at any angle contains a pole: rotating it does not help.
    return moved.width < 0.75 * plain.width ? seam_rotation_rad : 0;
}

} // namespace gcpw
} // namespace cv
