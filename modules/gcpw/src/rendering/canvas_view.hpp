// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#ifndef OPENCV_GCPW_CANVAS_VIEW_HPP
#define OPENCV_GCPW_CANVAS_VIEW_HPP

#include <opencv2/core.hpp>

namespace cv
{
namespace gcpw
{

/** @brief Where a picture shows the points of a flat canvas: through a homography, and then on a plane or on a sphere.

Full-resolution pixels on both sides. The picture of a sphere is (longitude, latitude) times its radius, as that of
cv::detail::SphericalWarper up to a shift: x to the right, y down, straight ahead at the origin. */
class CanvasView
{
public:
    /// The canvas as it is.
    CanvasView() : CanvasView(Matx33d::eye()) {}
    /// Flat. Lines that are straight on the canvas are straight.
    explicit CanvasView(const Matx33d& picture_from_canvas);
    /** @brief On a sphere around a camera.
    @param ray_from_canvas direction of (x, y, 1), of any length: x to the right, y down, z ahead
    @param radius of the sphere, px */
    static CanvasView onSphere(const Matx33d& ray_from_canvas, double radius);

    bool isFlat() const { return radius_ == 0; }
    /// The homography of a flat view; of a curved one the affine map that is right at a point and nearly so around it.
    Matx33d homographyAt(Point2d canvas) const;

    Point2d show(Point2d canvas) const;
    /// More than what a line of the canvas leaves its chord by, px, if the chord is so long.
    double bulge(double chord_px) const;
    /// Not finite where a ray does not meet the canvas.
    Point2d canvasAt(Point2d picture) const;

private:
    Matx33d forward_;
    Matx33d backward_;
    double radius_ = 0; ///< 0: flat
};

} // namespace gcpw
} // namespace cv

#endif
