// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#include "test_precomp.hpp"

#include "camera_scene.hpp"
#include "cameras/straighten.hpp"

namespace opencv_test
{
namespace
{

using gcpw::SetShape;

/// The true rotations as an estimator finds them: in the frame of a camera that was held askew.
std::vector<Matx33d> askew(std::vector<Matx33d> rotations)
{
    for (Matx33d& R : rotations)
        R = turnOf(0.7, -0.3, 0.2) * R;
    return rotations;
}

std::vector<Matx33d> stripOf(double roll, double pitch)
{
    std::vector<Matx33d> rotations;
    for (const double yaw : {-0.9, -0.3, 0.3, 0.9})
        rotations.push_back(turnOf(yaw, pitch, roll));
    return rotations;
}

std::vector<Matx33d> sweep()
{
    std::vector<Matx33d> rotations;
    for (const double pitch : {-0.3, 0.3, 0.9, 1.5})
        rotations.push_back(turnOf(0, pitch));
    return rotations;
}

TEST(Gcpw_Straighten, the_shape_of_a_set_is_that_of_its_turns)
{
    EXPECT_EQ(gcpw::shapeOf(askew(stripOf(0, 0.2))), SetShape::STRIP);
    EXPECT_EQ(gcpw::shapeOf(askew(sweep())), SetShape::COLUMN);
    EXPECT_EQ(gcpw::shapeOf(askew(stripOf(CV_PI / 2, 0))), SetShape::COLUMN) << "photographs on their side";
    EXPECT_EQ(gcpw::shapeOf(askew({turnOf(0.01), turnOf(-0.01), turnOf(0, 0.02)})), SetShape::SPOT);
    std::vector<Matx33d> grid;
    for (const double yaw : {-0.4, 0.0, 0.4})
        for (const double pitch : {-0.4, 0.0, 0.4})
            grid.push_back(turnOf(yaw, pitch));
    EXPECT_EQ(gcpw::shapeOf(askew(grid)), SetShape::STRIP) << "rows are kept level";
}

TEST(Gcpw_Straighten, a_strip_is_level_and_looks_ahead)
{
    const std::vector<Matx33d> rotations = askew(stripOf(0, 0.2));
    const Matx33d world = gcpw::straightening(rotations, SetShape::STRIP);
    EXPECT_NEAR(determinant(world), 1, 1e-9);
    Vec3d view(0, 0, 0);
    for (const Matx33d& R : rotations)
    {
        const Matx33d straight = world * R;
        EXPECT_NEAR(straight(1, 0), 0, 1e-6) << "an x axis leaves the horizon";
        EXPECT_GT(straight(1, 1), 0.9) << "upside down";
        view += Vec3d(straight(0, 2), straight(1, 2), straight(2, 2));
    }
    EXPECT_NEAR(view[0], 0, 1e-6);
    EXPECT_GT(view[2], 0);
}

TEST(Gcpw_Straighten, a_column_lies_along_the_equator_with_its_left_side_down)
{
    for (const std::vector<Matx33d>& set : {sweep(), stripOf(CV_PI / 2, 0), stripOf(-CV_PI / 2, 0)})
    {
        const std::vector<Matx33d> rotations = askew(set);
        const Matx33d world = gcpw::straightening(rotations, SetShape::COLUMN);
        EXPECT_NEAR(determinant(world), 1, 1e-9);
        for (const Matx33d& R : rotations)
        {
            const Matx33d straight = world * R;
            EXPECT_NEAR(straight(1, 2), 0, 1e-6) << "a view leaves the equator";
            EXPECT_NEAR(straight(1, 0), -1, 1e-6) << "the right side is not up";
        }
    }
}

TEST(Gcpw_Straighten, views_all_around_have_a_middle_too)
{
    std::vector<Matx33d> ring;
    for (int i = 0; i < 8; ++i)
        ring.push_back(turnOf(i * CV_PI / 4));
    const Matx33d world = gcpw::straightening(askew(ring), SetShape::STRIP);
    EXPECT_TRUE(checkRange(Mat(world)));
    EXPECT_NEAR(determinant(world), 1, 1e-9);
}

} // namespace
} // namespace opencv_test
