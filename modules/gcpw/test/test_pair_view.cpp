// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#include "test_precomp.hpp"

#include <cmath>
#include <opencv2/calib3d.hpp>
#include "api/pair_view.hpp"
#include "camera_turn.hpp"

namespace opencv_test
{
namespace
{

using namespace cv::gcpw;

const Size PHOTO(480, 360);
const double FOCAL = 480;

Matx33d about(int axis, double degrees)
{
    Vec3d w;
    w[axis] = degrees * CV_PI / 180;
    Mat R;
    Rodrigues(w, R);
    return Matx33d(R.ptr<double>());
}

/// The frame of the target from that of the source, both of one camera. @param target, source world from camera
Matx33d homographyOf(const Matx33d& target, const Matx33d& source)
{
    const Matx33d camera(FOCAL, 0, 0.5 * PHOTO.width, 0, FOCAL, 0.5 * PHOTO.height, 0, 0, 1);
    return camera * target.t() * source * camera.inv();
}

CanvasView viewOf(const Matx33d& target_from_source)
{
    return pairView(warpedLattice(Lattice(PHOTO, 16, 12), target_from_source), PHOTO, PHOTO);
}

/// Where the target shows a direction of the world.
Point2d onTarget(const Matx33d& target, const Vec3d& direction)
{
    const Vec3d ray = target.t() * direction;
    return {FOCAL * ray[0] / ray[2] + 0.5 * PHOTO.width, FOCAL * ray[1] / ray[2] + 0.5 * PHOTO.height};
}

TEST(Gcpw_PairView, a_pair_that_is_hardly_stretched_stays_flat_whatever_it_shows)
{
    EXPECT_TRUE(viewOf(Matx33d(1, 0, 200, 0, 1, 5, 0, 0, 1)).isFlat());
    EXPECT_TRUE(viewOf(homographyOf(about(1, 0), about(1, 10))).isFlat());
}

TEST(Gcpw_PairView, a_wide_turn_is_shown_on_a_sphere)
{
    const CanvasView view = viewOf(homographyOf(about(1, 24), about(1, -24)));
    ASSERT_FALSE(view.isFlat());
    // One pixel in the middle is one of the photographs.
    const Point2d middle = onTarget(about(1, 24), Vec3d(0, 0, 1));
    const Point2d above = onTarget(about(1, 24), Vec3d(0, -0.01, 1));
    EXPECT_NEAR(cv::norm(view.show(above) - view.show(middle)), 0.01 * FOCAL, 0.02 * 0.01 * FOCAL);
}

TEST(Gcpw_PairView, walls_are_upright_though_the_camera_looked_up_and_was_tilted)
{
    for (const double half : {16.0, 24.0})
    {
        const Matx33d pitch = about(0, 12);
        const Matx33d target = about(1, half) * pitch;
        const CanvasView view = viewOf(homographyOf(target, about(1, -half) * pitch));
        for (const double x : {-0.3, 0.0, 0.4})
        {
            const Point2d low = view.show(onTarget(target, Vec3d(x, 0.1, 1)));
            const Point2d high = view.show(onTarget(target, Vec3d(x, -0.4, 1)));
            EXPECT_LT(std::abs(high.x - low.x), 0.02 * std::abs(high.y - low.y)) << half << " " << x;
            EXPECT_LT(high.y, low.y);
        }
    }
}

TEST(Gcpw_PairView, what_no_turning_camera_explains_is_flat)
{
    Matx33d strange = homographyOf(about(1, 18), about(1, -18));
    strange = strange * Matx33d(1, 0, 0, 0, 1.35, 0, 0, 0, 1); // no camera has such pixels
    EXPECT_TRUE(viewOf(strange).isFlat());
}

} // namespace
} // namespace opencv_test
