// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
// What a picture is judged by before it is made, and the projections that are chosen by it.
#include "test_precomp.hpp"

#include "camera_scene.hpp"
#include "cameras/projection_choice.hpp"
#include "stitching/affine_warper.hpp"
#include "stitching/warper_names.hpp"

namespace opencv_test
{
namespace
{

using gcpw::PictureShape;
using gcpw::ProjectionChoice;

const double FOCAL = 600;

Ptr<cv::detail::RotationWarper> makeWarper(const std::string& name, float scale)
{
    return gcpw::trueWarper(gcpw::warperOfName(name)->create(scale));
}

PictureShape spherical(const std::vector<cv::detail::CameraParams>& cameras)
{
    const float scale = gcpw::medianFocal(cameras);
    return gcpw::shapeOfPicture(cameras, sizesOf(cameras.size()), *makeWarper("spherical", scale), 2 * CV_PI * scale);
}

std::vector<Matx33d> sweepOf(double yaw_step, double pitch_step, int count)
{
    std::vector<Matx33d> rotations;
    for (int i = 0; i < count; ++i)
        rotations.push_back(turnOf(yaw_step * (i - 0.5 * (count - 1)), pitch_step * (i - 0.5 * (count - 1))));
    return rotations;
}

ProjectionChoice chosen(const std::vector<Matx33d>& rotations)
{
    return gcpw::chooseProjection(camerasOf(rotations, FOCAL), sizesOf(rotations.size()), makeWarper);
}

TEST(Gcpw_PictureShape, a_strip_is_sound_and_smaller_than_its_photographs)
{
    const PictureShape shape = spherical(camerasOf(sweepOf(0.5, 0, 4), FOCAL));
    EXPECT_EQ(shape.fault, "");
    EXPECT_GT(shape.stretch, 1);
    EXPECT_LT(shape.stretch, 1.2);
    EXPECT_LT(shape.area, 0.8);
    EXPECT_NEAR(shape.size.height, SHOT.height, 0.1 * SHOT.height);
}

TEST(Gcpw_PictureShape, focal_lengths_that_exploded_are_named)
{
    std::vector<cv::detail::CameraParams> cameras = camerasOf(sweepOf(0.5, 0, 3), FOCAL);
    cameras[1].focal = 3 * FOCAL;
    EXPECT_NE(spherical(cameras).fault.find("differ"), std::string::npos);
    for (cv::detail::CameraParams& camera : cameras)
        camera.focal = 1e6;
    EXPECT_NE(spherical(cameras).fault.find("focal length"), std::string::npos);
    cameras[2].focal = std::numeric_limits<double>::quiet_NaN();
    EXPECT_NE(spherical(cameras).fault, "");
}

TEST(Gcpw_PictureShape, a_pole_is_out_of_proportion)
{
    EXPECT_NE(spherical(camerasOf({turnOf(0), turnOf(0, 0.7), turnOf(0, 1.4)}, FOCAL)).fault, "");
}

TEST(Gcpw_PictureShape, an_image_across_the_seam_is_not_stretched)
{
    const PictureShape shape = spherical(camerasOf({turnOf(CV_PI - 0.5), turnOf(CV_PI), turnOf(CV_PI + 0.5)}, FOCAL));
    EXPECT_LT(shape.stretch, 1.2);
}

TEST(Gcpw_PictureShape, misses_are_distances_of_matched_points)
{
    const std::vector<Matx33d> rotations = sweepOf(0.4, 0, 3);
    const std::vector<gcpw::Link> links = linksOfTurning(rotations, FOCAL);
    const Ptr<cv::detail::RotationWarper> warper = makeWarper("spherical", static_cast<float>(FOCAL));
    for (const double miss : gcpw::missesOf(camerasOf(rotations, FOCAL), links, *warper, 2 * CV_PI * FOCAL))
        EXPECT_LT(miss, 0.05);
    std::vector<cv::detail::CameraParams> cameras = camerasOf(rotations, FOCAL);
    cameras[1].R = Mat(Matx33f(turnOf(0.02) * rotations[1]));
    const std::vector<double> misses = gcpw::missesOf(cameras, links, *warper, 2 * CV_PI * FOCAL);
    EXPECT_NEAR(misses[0], 0.02 * FOCAL, 0.5);
}

TEST(Gcpw_ProjectionChoice, a_narrow_view_is_shown_on_the_plane_where_lines_stay_straight)
{
    const ProjectionChoice choice = chosen(sweepOf(0.15, 0, 3));
    EXPECT_EQ(choice.name, "plane");
    EXPECT_FALSE(choice.turned);
    EXPECT_EQ(choice.picture.fault, "");
}

TEST(Gcpw_ProjectionChoice, a_strip_is_shown_on_the_sphere)
{
    const ProjectionChoice choice = chosen(sweepOf(0.5, 0, 5));
    EXPECT_EQ(choice.name, "spherical");
    EXPECT_FALSE(choice.turned);
    EXPECT_LT(choice.picture.stretch, 1.3);
}

TEST(Gcpw_ProjectionChoice, a_sweep_upwards_is_turned_onto_the_equator)
{
    const ProjectionChoice choice = chosen(sweepOf(0, 0.5, 5));
    EXPECT_EQ(choice.name, "spherical");
    EXPECT_TRUE(choice.turned);
    EXPECT_LT(choice.picture.stretch, 1.3) << "a pole smears it";
    EXPECT_GT(choice.picture.size.width, choice.picture.size.height) << "turned, a column is wide";
}

TEST(Gcpw_ProjectionChoice, a_narrow_column_stands_on_the_plane)
{
    const ProjectionChoice choice = chosen(sweepOf(0, 0.15, 3));
    EXPECT_EQ(choice.name, "plane");
    EXPECT_FALSE(choice.turned);
    EXPECT_GT(choice.picture.size.height, SHOT.height);
    for (const Matx33d& R : sweepOf(0, 0.15, 3))
        EXPECT_GT((choice.world * R)(0, 0), 0.99) << "it lies on its side";
}

TEST(Gcpw_ProjectionChoice, a_set_around_a_pole_is_shown_about_its_middle)
{
    std::vector<Matx33d> rotations;
    for (const double yaw : {-2.0, -1.0, 0.0, 1.0, 2.0, 3.0})
        rotations.push_back(turnOf(yaw, 1.0));
    const ProjectionChoice choice = chosen(rotations);
    EXPECT_FALSE(choice.straight);
    EXPECT_EQ(choice.picture.fault, "");
    EXPECT_LT(choice.picture.stretch, 4);
}

TEST(Gcpw_ProjectionChoice, a_forced_projection_is_used)
{
    const std::vector<Matx33d> rotations = sweepOf(0.5, 0, 4);
    EXPECT_EQ(gcpw::chooseProjection(camerasOf(rotations, FOCAL), sizesOf(4), makeWarper, "cylindrical").name,
              "cylindrical");
}

} // namespace
} // namespace opencv_test
