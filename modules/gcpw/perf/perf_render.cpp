// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#include "perf_precomp.hpp"

#include <opencv2/imgproc.hpp>
#include <opencv2/stitching/detail/exposure_compensate.hpp>
#include <opencv2/stitching/detail/warpers.hpp>
#include "rendering/color_field.hpp"
#include "rendering/inverse_map.hpp"
#include "pair_problem.hpp"
#include "thread_count.hpp"

namespace opencv_test { namespace {

/// The source of the pair on its canvas.
struct Warped
{
    const PairProblem problem{false};
    gcpw::FrameScale full; ///< work and full resolution are one
    Mat map;
    Mat mask;
    Mat image;

    Warped()
    {
        build();
        remap(pairScene().source(), image, map, noArray(), INTER_LINEAR);
    }
    const gcpw::MeshGrid& mesh() const { return problem.states()[0].mesh; }
    void build() { gcpw::buildInverseMap(mesh(), full, full, gcpw::coveredRect(mesh(), full), map, mask); }
};

PERF_TEST(Gcpw_InverseMap, map_of_a_mesh)
{
    const ThreadCount threads(1);
    Warped warped;
    TEST_CYCLE() warped.build();
    CV_Assert(countNonZero(warped.mask) > pairScene().source().size().area() / 2);
    SANITY_CHECK_NOTHING();
}

PERF_TEST(Gcpw_InverseMap, map_of_the_spherical_warper)
{
    const ThreadCount threads(1);
    const Size size = pairScene().source().size();
    // Looking ahead at a moderate angle: as many canvas pixels as the image has, about.
    const Mat K = (Mat_<float>(3, 3) << 1200, 0, size.width / 2, 0, 1200, size.height / 2, 0, 0, 1);
    cv::detail::SphericalWarper warper(1200);
    Mat map_x;
    Mat map_y;
    TEST_CYCLE() warper.buildMaps(size, K, Mat::eye(3, 3, CV_32F), map_x, map_y);
    CV_Assert(std::abs(map_x.total() / static_cast<double>(size.area()) - 1) < 0.1);
    SANITY_CHECK_NOTHING();
}

PERF_TEST(Gcpw_ColorField, colors_of_a_grid)
{
    const ThreadCount threads(1);
    const Warped warped;
    // The default mesh; gain and bias of three channels.
    const Mat color = Mat(32, 32 * 6, CV_32FC1, Scalar(0.5)).reshape(6);
    const Size size = pairScene().source().size();
    const float x_scale = static_cast<float>(color.cols) / static_cast<float>(size.width);
    const float y_scale = static_cast<float>(color.rows) / static_cast<float>(size.height);
    Mat corrected;
    TEST_CYCLE()
    {
        warped.image.copyTo(corrected);
        gcpw::ColorField(color).apply(corrected, warped.mask, [&](Point pixel)
        {
            const Vec2f& at = warped.map.at<Vec2f>(pixel);
            return Point2f((at[0] + 0.5F) * x_scale, (at[1] + 0.5F) * y_scale);
        });
    }
    CV_Assert(corrected.size() == warped.image.size());
    SANITY_CHECK_NOTHING();
}

PERF_TEST(Gcpw_ColorField, colors_of_blocks_channels)
{
    const ThreadCount threads(1);
    const Warped warped;
    const std::vector<Point> corners{gcpw::coveredRect(warped.mesh(), warped.full).tl(), Point(0, 0)};
    const std::vector<UMat> images{warped.image.getUMat(ACCESS_READ), pairScene().target().getUMat(ACCESS_READ)};
    const UMat target_mask(pairScene().target().size(), CV_8UC1, Scalar(255));
    cv::detail::BlocksChannelsCompensator compensator;
    compensator.feed(corners, images, {{warped.mask.getUMat(ACCESS_READ), 255}, {target_mask, 255}});
    Mat corrected;
    TEST_CYCLE()
    {
        warped.image.copyTo(corrected);
        compensator.apply(0, corners[0], corrected, warped.mask);
    }
    CV_Assert(corrected.size() == warped.image.size());
    SANITY_CHECK_NOTHING();
}

}} // namespace
