// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#include "test_precomp.hpp"

#include "bent_mesh.hpp"

namespace opencv_test { namespace {

using namespace cv::gcpw;

const Lattice LATTICE(Size(160, 120), 8, 6); // cells of 20 x 20 px

TEST(Gcpw_MeshGrid, undeformed_it_only_shifts)
{
    const MeshGrid mesh(LATTICE, Point2d(7, -3));
    RNG rng = seeded(1);
    for (int i = 0; i < 200; ++i)
    {
        const Point2d p(rng.uniform(-0.5, 159.5), rng.uniform(-0.5, 119.5));
        EXPECT_LT(cv::norm(mesh.warp(p) - p - Point2d(7, -3)), 1e-10);
    }
    Point2d origin;
    EXPECT_TRUE(mesh.isTranslation(origin));
    EXPECT_EQ(origin, Point2d(7, -3));
    EXPECT_FALSE(bentMesh(LATTICE, 0.1, 2).isTranslation(origin));
}

TEST(Gcpw_MeshGrid, vertices_are_warped_onto_themselves_from_every_quad_around)
{
    const MeshGrid mesh = bentMesh(LATTICE, 5, 3);
    for (int cell = 0; cell < LATTICE.cellCount(); ++cell)
        for (int k = 0; k < 4; ++k)
        {
            CellPoint corner;
            corner.cell = cell;
            corner.weight[k] = 1;
            EXPECT_EQ(mesh.warp(corner), mesh.vertices()[LATTICE.vertexOf(cell, k)]);
        }
}

TEST(Gcpw_MeshGrid, inverting_undoes_warping_from_any_hint)
{
    for (int seed = 0; seed < 10; ++seed)
    {
        const MeshGrid mesh = bentMesh(LATTICE, 0.5 * seed, seed, Point2d(30, 10));
        ASSERT_EQ(mesh.countFolds(), 0);
        RNG rng = seeded(seed);
        for (int i = 0; i < 2000; ++i)
        {
            const Point2d p(rng.uniform(-0.5, 159.5), rng.uniform(-0.5, 119.5));
            int hint = rng.uniform(-5, LATTICE.cellCount() + 5);
            CellPoint point;
            ASSERT_TRUE(mesh.invert(mesh.warp(p), hint, point)) << p << " seed " << seed;
            ASSERT_LT(cv::norm(LATTICE.referencePoint(point) - p), 1e-6);
            ASSERT_EQ(hint, point.cell);
        }
    }
}

TEST(Gcpw_MeshGrid, what_the_mesh_does_not_cover_has_no_inverse)
{
    const MeshGrid mesh = bentMesh(LATTICE, 5, 6);
    const Rect2d bounds = mesh.bounds();
    for (const Point2d& p :
         {Point2d(bounds.x - 1, 60), Point2d(bounds.br().x + 1, 60), Point2d(80, bounds.y - 1),
          Point2d(80, bounds.br().y + 1), Point2d(-1e5, 1e5), Point2d(std::numeric_limits<double>::quiet_NaN(), 3)})
    {
        int hint = -1;
        CellPoint point;
        EXPECT_FALSE(mesh.invert(p, hint, point)) << p;
    }
}

TEST(Gcpw_MeshGrid, jacobian_equals_finite_differences)
{
    const MeshGrid mesh = bentMesh(LATTICE, 5, 7);
    RNG rng = seeded(8);
    const double step = 1e-5;
    for (int i = 0; i < 300; ++i)
    {
        const Point2d p(rng.uniform(0, 8) * 20 + rng.uniform(0.1, 19.4),
                        rng.uniform(0, 6) * 20 + rng.uniform(0.1, 19.4));
        const Matx22d jacobian = mesh.jacobian(LATTICE.locate(p));
        const Point2d dx = (mesh.warp(p + Point2d(step, 0)) - mesh.warp(p - Point2d(step, 0))) / (2 * step);
        const Point2d dy = (mesh.warp(p + Point2d(0, step)) - mesh.warp(p - Point2d(0, step))) / (2 * step);
        EXPECT_LT(cv::norm(jacobian - Matx22d(dx.x, dy.x, dx.y, dy.y), NORM_INF), 1e-7);
    }
}

TEST(Gcpw_MeshGrid, corner_areas_of_an_upright_rectangle_are_its_area)
{
    const MeshGrid mesh(LATTICE);
    for (int k = 0; k < 4; ++k)
        EXPECT_NEAR(mesh.cornerArea(11, k), 400, 1e-9);
}

TEST(Gcpw_MeshGrid, corner_areas_are_the_jacobians_determinant_at_the_corners)
{
    const MeshGrid mesh = bentMesh(LATTICE, 6, 9);
    for (int cell = 0; cell < LATTICE.cellCount(); ++cell)
        for (int k = 0; k < 4; ++k)
        {
            CellPoint corner;
            corner.cell = cell;
            corner.weight[k] = 1;
            EXPECT_NEAR(mesh.cornerArea(cell, k), 400 * determinant(mesh.jacobian(corner)), 1e-8);
        }
}

TEST(Gcpw_MeshGrid, every_fold_is_counted_once)
{
    MeshGrid mesh(LATTICE);
    EXPECT_EQ(mesh.countFolds(), 0);
    // A vertex inside, pushed over the opposite corner of one quad: that quad and its two side neighbours turn over.
    const int vertex = LATTICE.vertexOf(3 * 8 + 4, 3);
    mesh.vertices()[vertex] -= Point2d(12, 12);
    EXPECT_EQ(mesh.countFolds(), 1);
    mesh.vertices()[vertex] = Point2d(std::numeric_limits<double>::quiet_NaN(), 0);
    EXPECT_EQ(mesh.countFolds(), 4);
}

TEST(Gcpw_MeshGrid, a_mirrored_mesh_is_all_folds)
{
    const MeshGrid mesh = affineMesh(MeshGrid(LATTICE), Matx22d(-1, 0, 0, 1), Point2d(200, 0));
    EXPECT_EQ(mesh.countFolds(), LATTICE.cellCount());
    const MeshGrid turned = affineMesh(MeshGrid(LATTICE), Matx22d(-1, 0, 0, -1), Point2d(200, 200));
    EXPECT_EQ(turned.countFolds(), 0);
}

TEST(Gcpw_MeshGrid, bounds_hold_every_warped_point)
{
    const MeshGrid mesh = bentMesh(LATTICE, 8, 10);
    const Rect2d bounds = mesh.bounds();
    RNG rng = seeded(11);
    for (int i = 0; i < 500; ++i)
    {
        const Point2d p = mesh.warp(Point2d(rng.uniform(-0.5, 159.5), rng.uniform(-0.5, 119.5)));
        EXPECT_TRUE(p.x >= bounds.x && p.y >= bounds.y && p.x <= bounds.br().x && p.y <= bounds.br().y);
    }
}

TEST(Gcpw_MeshGrid, distance_of_meshes_is_that_of_the_farthest_vertex)
{
    const MeshGrid mesh = bentMesh(LATTICE, 5, 12);
    MeshGrid other = mesh;
    EXPECT_EQ(maxVertexDistance(mesh, other), 0);
    other.vertices()[3] += Point2d(1, 0);
    other.vertices()[17] += Point2d(-3, 4);
    EXPECT_NEAR(maxVertexDistance(mesh, other), 5, 1e-12);
}

TEST(Gcpw_MeshGrid, a_quad_without_area_cannot_be_inverted)
{
    const std::array<Point2d, 4> flat{{Point2d(0, 0), Point2d(1, 1), Point2d(2, 2), Point2d(3, 3)}};
    double u = 0;
    double v = 0;
    EXPECT_FALSE(invertBilinear(flat, Point2d(0.3, 0.9), u, v));
}

}} // namespace
