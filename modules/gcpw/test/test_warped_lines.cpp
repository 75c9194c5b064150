// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#include "test_precomp.hpp"

#include "rig_scene.hpp"
#include "stitching/warped_lines.hpp"

namespace opencv_test { namespace {

TEST(Gcpw_WarpedLines, borders_of_a_photograph_lie_where_the_warper_has_them)
{
    const cv::detail::CameraParams camera = cameraAt(0.3, 0.1, 0.05);
    const Mat photograph = photographOf(camera, 0, 0);
    cv::detail::SphericalWarper warper(static_cast<float>(RIG_FOCAL));
    const Mat K = intrinsics(camera);
    const Point corner = warper.warpRoi(photograph.size(), K, camera.R).tl();
    const gcpw::KnownLines lines = gcpw::warpedLines(photograph, warper, K, camera.R, corner, 0.06);
    ASSERT_EQ(lines.borders.size(), size_t(4));
    // At half the resolution the outermost pixel's centre is half a pixel further inside.
    const Point2f corners[] = {Point2f(0, 0), Point2f(399, 0), Point2f(399, 299), Point2f(0, 299)};
    for (int k = 0; k < 4; ++k)
    {
        const Point2f expected = warper.warpPoint(corners[k], K, camera.R) - Point2f(corner);
        EXPECT_LT(cv::norm(lines.borders[k].front() - expected), 1) << k;
        EXPECT_LT(cv::norm(lines.borders[(k + 3) % 4].back() - expected), 1) << k;
        EXPECT_GT(lines.borders[k].size(), size_t(10)) << "a chord cannot follow the sphere";
    }
}

}} // namespace
