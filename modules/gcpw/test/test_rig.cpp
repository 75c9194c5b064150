// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#include "test_precomp.hpp"

#include <limits>
#include "log.hpp"
#include "refusal.hpp"
#include "rig_scene.hpp"

namespace opencv_test
{
namespace
{

const double NOT_A_NUMBER = std::numeric_limits<double>::quiet_NaN();
const double ENDLESS = std::numeric_limits<double>::infinity();

gcpw::Rig goodRig()
{
    gcpw::Rig rig = bentRig(makePtr<cv::SphericalWarper>(), {cameraAt(-0.3), cameraAt(0.3)}, 3, {0, 0.1});
    rig.image_sizes = {RIG_IMAGE, RIG_IMAGE};
    rig.component = {4, 2};
    return rig;
}

/// Rig::check() names `part`, and whatever takes a rig does without this one and logs why.
void expectRefused(const gcpw::Rig& rig, const std::string& part)
{
    opencv_test::expectRefused([&] { rig.check(); }, part);
    EXPECT_FALSE(rig.usable()) << part;
    const Ptr<WarperCreator> base = makePtr<cv::SphericalWarper>();
    const Mat K = intrinsics(goodRig().cameras[0]);
    const Mat R = goodRig().cameras[0].R;
    const Rect expected = base->create(300)->warpRoi(RIG_IMAGE, K, R);
    const Log log;
    expectTaken([&] { EXPECT_EQ(gcpw::GcpwWarper(base, rig).create(300)->warpRoi(RIG_IMAGE, K, R), expected); });
    EXPECT_EQ(log.count(part), 1) << part;
    gcpw::GcpwWarper warper(base, goodRig());
    EXPECT_NE(warper.create(300)->warpRoi(RIG_IMAGE, K, R), expected);
    expectTaken([&] { warper.setRig(rig); });
    EXPECT_EQ(log.count(part), 2) << part;
    EXPECT_EQ(warper.create(300)->warpRoi(RIG_IMAGE, K, R), expected);
    expectTaken([&] { gcpw::GcpwRotationWarper(base->create(300), rig); });
    EXPECT_EQ(log.count(part), 3) << part;
}

TEST(Gcpw_Rig, a_good_rig_and_one_without_a_refinement_are_taken)
{
    const Ptr<WarperCreator> base = makePtr<cv::SphericalWarper>();
    expectTaken([&] { gcpw::GcpwWarper(base, goodRig()); });
    expectTaken([&] { gcpw::GcpwWarper(base, gcpw::Rig()); });
    gcpw::Rig rough = goodRig();
    gcpw::Report report;
    report.status = gcpw::Status::ROUGH;
    rough.alignment = gcpw::Alignment(std::vector<gcpw::Alignment::Image>(), Size2d(1, 1), report);
    rough.cameras[0].focal = NOT_A_NUMBER; // may be the reason
    expectTaken([&] { gcpw::GcpwWarper(base, rough); });
}

TEST(Gcpw_Rig, counts_that_do_not_fit_are_refused)
{
    gcpw::Rig rig = goodRig();
    rig.turns.pop_back();
    expectRefused(rig, "turns");
    rig = goodRig();
    rig.cameras.pop_back();
    expectRefused(rig, "cameras");
    rig = goodRig();
    rig.image_sizes.emplace_back(3, 3);
    expectRefused(rig, "image_sizes");
    rig = goodRig();
    rig.component.push_back(0);
    expectRefused(rig, "component");
}

TEST(Gcpw_Rig, a_rotation_that_is_none_is_refused)
{
    gcpw::Rig rig = goodRig();
    for (const Mat& R :
         {Mat(), Mat(Mat::eye(2, 2, CV_32F)), Mat(9, 1, CV_32F, Scalar(1)), Mat(3, 3, CV_32FC2, Scalar::all(1))})
    {
        rig.cameras[1].R = R;
        expectRefused(rig, "R of camera 1");
    }
    for (const double bad : {NOT_A_NUMBER, ENDLESS})
    {
        rig.cameras[1].R = Mat::eye(3, 3, CV_32F);
        rig.cameras[1].R.at<float>(1, 2) = static_cast<float>(bad);
        expectRefused(rig, "R of camera 1");
    }
}

TEST(Gcpw_Rig, numbers_that_no_camera_has_are_named)
{
    typedef double cv::detail::CameraParams::*Part;
    const std::pair<Part, const char*> positive[] = {{&cv::detail::CameraParams::focal, "focal of camera 0"},
                                                     {&cv::detail::CameraParams::aspect, "aspect of camera 0"}};
    for (const auto& part : positive)
        for (const double bad : {NOT_A_NUMBER, ENDLESS, 0.0, -1.0})
        {
            gcpw::Rig rig = goodRig();
            rig.cameras[0].*part.first = bad;
            expectRefused(rig, part.second);
        }
    for (const double bad : {NOT_A_NUMBER, -ENDLESS})
    {
        gcpw::Rig rig = goodRig();
        rig.cameras[1].ppx = bad;
        expectRefused(rig, "principal point of camera 1");
        rig = goodRig();
        rig.cameras[1].ppy = bad;
        expectRefused(rig, "principal point of camera 1");
    }
}

TEST(Gcpw_Rig, a_mesh_beyond_any_canvas_is_named)
{
    for (const double bad : {3e9, -1e300})
    {
        gcpw::Rig rig = goodRig();
        std::vector<gcpw::Alignment::Image> images = {rig.alignment.image(0), rig.alignment.image(1)};
        images[1].mesh = images[1].mesh.clone();
        images[1].mesh.at<Vec2d>(2, 3)[1] = bad;
        rig.alignment = gcpw::Alignment(images, Size2d(1, 1), gcpw::Report());
        expectRefused(rig, "mesh of image 1");
    }
    gcpw::Rig rig = goodRig();
    const std::vector<gcpw::Alignment::Image> images = {rig.alignment.image(0), rig.alignment.image(1)};
    rig.alignment = gcpw::Alignment(images, Size2d(1e-300, 1e-300), gcpw::Report());
    expectRefused(rig, "mesh of image 0");
}

TEST(Gcpw_Rig, scales_turns_components_and_sizes_out_of_range_are_named)
{
    gcpw::Rig rig;
    for (const double bad : {NOT_A_NUMBER, ENDLESS, 0.0, -300.0})
    {
        rig = goodRig();
        rig.scale = static_cast<float>(bad);
        expectRefused(rig, "scale of a rig");
        rig = goodRig();
        rig.work_scale = bad;
        expectRefused(rig, "work_scale");
    }
    for (const double bad : {NOT_A_NUMBER, ENDLESS, 1e300, -7.0})
    {
        rig = goodRig();
        rig.turns[1] = bad;
        expectRefused(rig, "turns[1]");
    }
    rig = goodRig();
    rig.component = {3, -1};
    expectRefused(rig, "component[1] of a rig is -1");
    rig.component = {3, 3};
    expectRefused(rig, "component[1] of a rig is 3");
    rig = goodRig();
    rig.image_sizes[0] = Size(0, 10);
    expectRefused(rig, "image_sizes[0]");
}

} // namespace
} // namespace opencv_test
