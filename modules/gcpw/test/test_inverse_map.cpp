// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#include "test_precomp.hpp"

#include "bent_mesh.hpp"
#include "geometry/homography.hpp"
#include "rendering/inverse_map.hpp"

namespace opencv_test
{
namespace
{

using namespace cv::gcpw;

const Lattice LATTICE(Size(160, 120), 8, 6);

TEST(Gcpw_InverseMap, an_identity_mesh_gives_the_identity_map)
{
    Mat map;
    Mat mask;
    buildInverseMap(MeshGrid(LATTICE), FrameScale(), FrameScale(), Rect(0, 0, 160, 120), map, mask);
    ASSERT_EQ(map.type(), CV_32FC2);
    ASSERT_EQ(mask.type(), CV_8UC1);
    EXPECT_EQ(countNonZero(mask), 160 * 120);
    for (int y = 0; y < 120; ++y)
        for (int x = 0; x < 160; ++x)
            ASSERT_LE(cv::norm(map.at<Vec2f>(y, x) - Vec2f(static_cast<float>(x), static_cast<float>(y)), NORM_INF),
                      1e-5);
}

TEST(Gcpw_InverseMap, the_map_inverts_the_mesh)
{
    const MeshGrid mesh = bentMesh(LATTICE, 5, 1, Point2d(12, -7));
    const Rect roi = coveredRect(mesh, FrameScale());
    Mat map;
    Mat mask;
    buildInverseMap(mesh, FrameScale(), FrameScale(), roi, map, mask);
    EXPECT_GT(countNonZero(mask), 160 * 120 * 9 / 10);
    for (int y = 0; y < roi.height; ++y)
        for (int x = 0; x < roi.width; ++x)
            if (mask.at<uchar>(y, x))
            {
                const Vec2f p = map.at<Vec2f>(y, x);
                ASSERT_LT(cv::norm(mesh.warp(Point2d(p[0], p[1])) - Point2d(x + roi.x, y + roi.y)), 1e-3);
            }
}

TEST(Gcpw_InverseMap, the_mask_is_exactly_where_the_mesh_covers_the_pixel_centre)
{
    const MeshGrid mesh = bentMesh(LATTICE, 5, 2, Point2d(3.3, 4.4));
    const Rect roi = coveredRect(mesh, FrameScale()) + Point(-5, 3) + Size(10, 0);
    Mat map;
    Mat mask;
    buildInverseMap(mesh, FrameScale(), FrameScale(), roi, map, mask);
    int hint = -1;
    CellPoint point;
    for (int y = 0; y < roi.height; ++y)
        for (int x = 0; x < roi.width; ++x)
        {
            const bool covered = mesh.invert(Point2d(x + roi.x, y + roi.y), hint, point);
            ASSERT_EQ(mask.at<uchar>(y, x), covered ? 255 : 0) << Point(x, y);
            if (!covered)
            {
                ASSERT_EQ(map.at<Vec2f>(y, x), Vec2f(-1, -1));
            }
        }
}

TEST(Gcpw_InverseMap, neighbouring_quads_leave_no_gap)
{
    const MeshGrid mesh = bentMesh(LATTICE, 6, 3);
    ASSERT_EQ(mesh.countFolds(), 0);
    Mat map;
    Mat mask;
    const Rect middle(20, 20, 120, 80); // every pixel here is covered, whatever the jitter
    buildInverseMap(mesh, FrameScale(), FrameScale(), middle, map, mask);
    EXPECT_EQ(countNonZero(mask), middle.area());
}

TEST(Gcpw_InverseMap, the_covered_rectangle_holds_every_covered_pixel_and_touches_them)
{
    const MeshGrid mesh = affineMesh(MeshGrid(LATTICE), Matx22d(0.9, 0, 0, 1.2), Point2d(10.2, -30.6));
    const Rect rect = coveredRect(mesh, FrameScale());
    const Rect larger = rect + Point(-3, -3) + Size(6, 6);
    Mat map;
    Mat mask;
    buildInverseMap(mesh, FrameScale(), FrameScale(), larger, map, mask);
    EXPECT_EQ(boundingRect(mask), Rect(Point(3, 3), rect.size()));
}

TEST(Gcpw_InverseMap, full_resolution_shows_the_same_warp)
{
    const MeshGrid mesh = bentMesh(LATTICE, 4, 4, Point2d(9, 9));
    const FrameScale canvas(Size(100, 100), Size(250, 300));
    const FrameScale source(Size(160, 120), Size(480, 240));
    const Rect roi = coveredRect(mesh, canvas);
    Mat map;
    Mat mask;
    buildInverseMap(mesh, canvas, source, roi, map, mask);
    for (int y = 0; y < roi.height; y += 3)
        for (int x = 0; x < roi.width; x += 3)
            if (mask.at<uchar>(y, x))
            {
                const Vec2f p = map.at<Vec2f>(y, x);
                const Point2d seen = mesh.warp(source.toWork(Point2d(p[0], p[1])));
                ASSERT_LT(cv::norm(seen - canvas.toWork(Point2d(x + roi.x, y + roi.y))), 1e-3);
            }
}

TEST(Gcpw_InverseMap, frame_scales_act_on_pixel_squares)
{
    const FrameScale half(Size(50, 100), Size(100, 400));
    EXPECT_LT(cv::norm(half.toWork(Point2d(-0.5, -0.5)) - Point2d(-0.5, -0.5)), 1e-12);
    EXPECT_LT(cv::norm(half.toWork(Point2d(99.5, 399.5)) - Point2d(49.5, 99.5)), 1e-12);
    EXPECT_LT(cv::norm(half.toFull(half.toWork(Point2d(31, 77))) - Point2d(31, 77)), 1e-12);
}

TEST(Gcpw_InverseMap, one_thread_and_many_give_the_same_bits)
{
    const MeshGrid mesh = bentMesh(LATTICE, 5, 5);
    const FrameScale scale(Size(1, 1), Size(3, 3));
    const Rect roi = coveredRect(mesh, scale);
    Mat maps[2];
    Mat masks[2];
    const int threads = getNumThreads();
    for (int i = 0; i < 2; ++i)
    {
        setNumThreads(i == 0 ? threads : 1);
        buildInverseMap(mesh, scale, scale, roi, maps[i], masks[i]);
    }
    setNumThreads(threads);
    EXPECT_EQ(cv::norm(maps[0], maps[1], NORM_INF), 0);
    EXPECT_EQ(cv::norm(masks[0], masks[1], NORM_INF), 0);
}

TEST(Gcpw_InverseMap, a_rectangle_beside_the_mesh_stays_empty)
{
    Mat map;
    Mat mask;
    buildInverseMap(MeshGrid(LATTICE), FrameScale(), FrameScale(), Rect(500, 500, 30, 20), map, mask);
    EXPECT_EQ(mask.size(), Size(30, 20));
    EXPECT_EQ(countNonZero(mask), 0);
}

TEST(Gcpw_InverseMap, a_mesh_beyond_any_canvas_is_refused_and_not_wrapped_around)
{
    for (const double far : {1e300, -1e300, 3e9, -3e9, 2147483648.0, -2147483648.0})
    {
        MeshGrid mesh(LATTICE);
        mesh.vertices()[3].x = far;
        EXPECT_THROW(coveredRect(mesh, FrameScale()), cv::Exception) << far;
        mesh = MeshGrid(LATTICE);
        mesh.vertices()[3].y = far;
        EXPECT_THROW(coveredRect(mesh, FrameScale()), cv::Exception) << far;
    }
    FrameScale tiny;
    tiny.x = tiny.y = 1e-300;
    EXPECT_THROW(coveredRect(MeshGrid(LATTICE), tiny), cv::Exception);
}

TEST(Gcpw_InverseMap, in_a_view_every_pixel_shows_what_the_view_makes_of_its_place_on_the_canvas)
{
    const FrameScale canvas(Size(160, 120), Size(320, 240));
    const MeshGrid mesh = bentMesh(LATTICE, 5, 4, Point2d(12, -7));
    for (const CanvasView& view : {CanvasView(Matx33d(0.9, 0.1, 5, -0.1, 0.8, -3, 4e-4, 2e-4, 1)),
                                   CanvasView::onSphere(Matx33d(1, 0.05, -150, -0.05, 1, -100, 0.1, 0.2, 250), 250)})
    {
        const MeshGrid seen = viewed(mesh, canvas, view);
        const Rect roi = viewedBounds(mesh, canvas, view);
        Mat map;
        Mat mask;
        buildInverseMap(mesh, canvas, FrameScale(), roi, map, mask, view);
        EXPECT_GT(countNonZero(mask), roi.area() / 2);
        for (int y = 0; y < roi.height; ++y)
            for (int x = 0; x < roi.width; ++x)
            {
                if (!mask.at<uchar>(y, x))
                    continue;
                const Vec2f p = map.at<Vec2f>(y, x);
                const Point2d shown = view.show(canvas.toFull(mesh.warp(Point2d(p[0], p[1]))));
                ASSERT_LT(cv::norm(shown - Point2d(x + roi.x, y + roi.y)), 1e-3);
            }
        // Vertices are shown where they are; the mask ends there.
        for (const Point2d& vertex : seen.vertices())
            EXPECT_TRUE(Rect2d(Point2d(roi.x - 1, roi.y - 1), Size2d(roi.width + 1, roi.height + 1)).contains(vertex))
                << vertex;
        // No pixel is left out: where those on either side are covered, so is it.
        for (int y = 1; y + 1 < roi.height; ++y)
            for (int x = 1; x + 1 < roi.width; ++x)
                ASSERT_TRUE(mask.at<uchar>(y, x) || !mask.at<uchar>(y, x - 1) || !mask.at<uchar>(y, x + 1) ||
                            !mask.at<uchar>(y - 1, x) || !mask.at<uchar>(y + 1, x));
    }
}

} // namespace
} // namespace opencv_test
