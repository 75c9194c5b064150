// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#include "test_precomp.hpp"

#include <cmath>
#include "geometry/homography.hpp"
#include "rendering/canvas_view.hpp"

namespace opencv_test
{
namespace
{

using namespace cv::gcpw;

const Matx33d HOMOGRAPHY(0.9, 0.1, 5, -0.1, 0.8, -3, 4e-4, 2e-4, 1);
const double FOCAL = 400;
/// Rays of a camera of 640 x 480 px that looks a little upwards.
const Matx33d RAYS = Matx33d(1, 0, 0, 0, std::cos(0.2), -std::sin(0.2), 0, std::sin(0.2), std::cos(0.2)) *
                     Matx33d(1, 0, -320, 0, 1, -240, 0, 0, FOCAL);

TEST(Gcpw_CanvasView, what_is_shown_comes_back_to_its_place)
{
    for (const CanvasView& view : {CanvasView(), CanvasView(HOMOGRAPHY), CanvasView::onSphere(RAYS, FOCAL)})
        for (int y = 0; y <= 480; y += 40)
            for (int x = 0; x <= 640; x += 40)
                EXPECT_LT(cv::norm(view.canvasAt(view.show(Point2d(x, y))) - Point2d(x, y)), 1e-9) << x << ", " << y;
}

TEST(Gcpw_CanvasView, a_flat_view_is_its_homography)
{
    const CanvasView view(HOMOGRAPHY);
    EXPECT_TRUE(view.isFlat());
    EXPECT_EQ(view.homographyAt(Point2d(7, 9)), HOMOGRAPHY);
    EXPECT_EQ(view.bulge(100), 0);
    EXPECT_LT(cv::norm(view.show(Point2d(30, 40)) - applyHomography(HOMOGRAPHY, Point2d(30, 40))), 1e-12);
}

TEST(Gcpw_CanvasView, a_sphere_shows_directions_as_longitude_and_latitude)
{
    const CanvasView view = CanvasView::onSphere(Matx33d(1, 0, 0, 0, 1, 0, 0, 0, FOCAL), FOCAL);
    EXPECT_FALSE(view.isFlat());
    EXPECT_LT(cv::norm(view.show(Point2d())), 1e-12);
    EXPECT_LT(cv::norm(view.show(Point2d(FOCAL, 0)) - Point2d(FOCAL * CV_PI / 4, 0)), 1e-9);
    EXPECT_LT(cv::norm(view.show(Point2d(0, FOCAL)) - Point2d(0, FOCAL * CV_PI / 4)), 1e-9);
    // A ray that looks back meets the canvas nowhere.
    EXPECT_FALSE(std::isfinite(view.canvasAt(Point2d(FOCAL * 0.9 * CV_PI, 0)).x));
}

TEST(Gcpw_CanvasView, the_homography_of_a_sphere_is_right_near_its_point)
{
    const CanvasView view = CanvasView::onSphere(RAYS, FOCAL);
    const Point2d at(500, 100);
    EXPECT_LT(cv::norm(applyHomography(view.homographyAt(at), at) - view.show(at)), 1e-9);
    const Point2d near = at + Point2d(6, -8);
    EXPECT_LT(cv::norm(applyHomography(view.homographyAt(at), near) - view.show(near)), 0.2);
}

TEST(Gcpw_CanvasView, a_line_leaves_its_chord_by_less_than_the_bulge)
{
    const CanvasView view = CanvasView::onSphere(RAYS, FOCAL);
    for (int y = 0; y <= 400; y += 80)
        for (int x = 0; x <= 560; x += 80)
            for (const Point2d step : {Point2d(80, 0), Point2d(0, 80), Point2d(80, 80)})
            {
                const Point2d a = view.show(Point2d(x, y));
                const Point2d b = view.show(Point2d(x, y) + step);
                const Point2d middle = view.show(Point2d(x, y) + 0.5 * step);
                const double length = cv::norm(b - a);
                EXPECT_LT(std::abs((b - a).cross(middle - a)) / length, view.bulge(length));
            }
}

} // namespace
} // namespace opencv_test
