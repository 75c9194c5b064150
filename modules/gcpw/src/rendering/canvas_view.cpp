// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#include "rendering/canvas_view.hpp"

#include <cmath>
#include <limits>
#include "geometry/homography.hpp"

namespace cv
{
namespace gcpw
{

CanvasView::CanvasView(const Matx33d& picture_from_canvas)
    : forward_(picture_from_canvas), backward_(picture_from_canvas.inv())
{
}

CanvasView CanvasView::onSphere(const Matx33d& ray_from_canvas, double radius)
{
    CanvasView view(ray_from_canvas);
    view.radius_ = radius;
    return view;
}

Matx33d CanvasView::homographyAt(Point2d canvas) const
{
    if (isFlat())
        return forward_;
    const double step = 1; // px: a sphere is flat that near
    const Point2d at = show(canvas);
    const Point2d dx = (show(canvas + Point2d(step, 0)) - show(canvas - Point2d(step, 0))) * (0.5 / step);
    const Point2d dy = (show(canvas + Point2d(0, step)) - show(canvas - Point2d(0, step))) * (0.5 / step);
    const Point2d shift = at - canvas.x * dx - canvas.y * dy;
    return {dx.x, dy.x, shift.x, dx.y, dy.y, shift.y, 0, 0, 1};
}

Point2d CanvasView::show(Point2d canvas) const
{
    if (isFlat())
        return applyHomography(forward_, canvas);
    const Vec3d ray = forward_ * Vec3d(canvas.x, canvas.y, 1);
    return radius_ * Point2d(std::atan2(ray[0], ray[2]), std::atan2(ray[1], std::hypot(ray[0], ray[2])));
}

double CanvasView::bulge(double chord_px) const
{
    // Half of it on the equator. Straight lines are great circles, which the picture bends more the farther from there.
    return isFlat() ? 0 : 1 + chord_px * chord_px / (4 * radius_);
}

Point2d CanvasView::canvasAt(Point2d picture) const
{
    if (isFlat())
        return applyHomography(backward_, picture);
    const double longitude = picture.x / radius_;
    const double latitude = picture.y / radius_;
    const Vec3d ray(std::sin(longitude) * std::cos(latitude), std::sin(latitude),
                    std::cos(longitude) * std::cos(latitude));
    const Vec3d at = backward_ * ray;
    const double nowhere = std::numeric_limits<double>::quiet_NaN();
    return at[2] > 0 ? Point2d(at[0] / at[2], at[1] / at[2]) : Point2d(nowhere, nowhere);
}

} // namespace gcpw
} // namespace cv
