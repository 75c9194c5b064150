// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#include "test_precomp.hpp"

#include <limits>
#include <numeric>
#include "geometry/lattice.hpp"
#include "seeded.hpp"

namespace opencv_test { namespace {

using namespace cv::gcpw;

Point2d randomInside(RNG& rng, Size size)
{
    return {rng.uniform(-0.5, size.width - 0.5), rng.uniform(-0.5, size.height - 0.5)};
}

TEST(Gcpw_Lattice, weights_sum_to_one_everywhere_inside)
{
    const Lattice lattice(Size(103, 57), 7, 5);
    RNG rng = seeded(1);
    for (int i = 0; i < 1000; ++i)
    {
        const CellPoint point = lattice.locate(randomInside(rng, lattice.imageSize()));
        EXPECT_NEAR(std::accumulate(point.weight.begin(), point.weight.end(), 0.0), 1, 1e-12);
        for (const double weight : point.weight)
            EXPECT_GE(weight, -1e-12);
    }
}

TEST(Gcpw_Lattice, a_located_point_is_the_weighted_mean_of_its_corners)
{
    const Lattice lattice(Size(103, 57), 7, 5);
    RNG rng = seeded(2);
    for (int i = 0; i < 1000; ++i)
    {
        const Point2d p = randomInside(rng, lattice.imageSize());
        const CellPoint point = lattice.locate(p);
        Point2d mean;
        for (int k = 0; k < 4; ++k)
            mean += point.weight[k] * lattice.referenceVertex(lattice.vertexOf(point.cell, k));
        EXPECT_LT(cv::norm(mean - p), 1e-10);
        EXPECT_LT(cv::norm(lattice.referencePoint(point) - p), 1e-10);
    }
}

TEST(Gcpw_Lattice, it_covers_the_pixel_squares_and_no_more)
{
    const Lattice lattice(Size(103, 57), 7, 5);
    EXPECT_EQ(lattice.referenceVertex(0), Point2d(-0.5, -0.5));
    EXPECT_LT(cv::norm(lattice.referenceVertex(lattice.vertexCount() - 1) - Point2d(102.5, 56.5)), 1e-12);
    EXPECT_TRUE(lattice.contains(Point2d(-0.5, -0.5)));
    EXPECT_TRUE(lattice.contains(Point2d(102.5, 56.5)));
    for (const Point2d& outside : {Point2d(-0.51, 3), Point2d(3, -0.51), Point2d(102.51, 3), Point2d(3, 56.51)})
        EXPECT_FALSE(lattice.contains(outside)) << outside;
    EXPECT_FALSE(lattice.contains(Point2d(std::numeric_limits<double>::quiet_NaN(), 0)));
}

TEST(Gcpw_Lattice, a_lattice_of_the_same_cells_fits_the_image_at_any_scale)
{
    const Lattice small(Size(64, 48), 8, 6);
    const Lattice large(Size(640, 480), 8, 6);
    for (int i = 0; i < small.vertexCount(); ++i)
    {
        const Point2d p = small.referenceVertex(i) + Point2d(0.5, 0.5);
        EXPECT_LT(cv::norm(10 * p - Point2d(0.5, 0.5) - large.referenceVertex(i)), 1e-10);
    }
}

TEST(Gcpw_Lattice, corners_are_numbered_row_by_row)
{
    const Lattice lattice(Size(30, 20), 3, 2);
    EXPECT_EQ(lattice.cellCount(), 6);
    EXPECT_EQ(lattice.vertexCount(), 12);
    const int expected[] = {5, 6, 9, 10}; // of the cell in row 1, column 1
    for (int k = 0; k < 4; ++k)
        EXPECT_EQ(lattice.vertexOf(4, k), expected[k]);
}

TEST(Gcpw_Lattice, points_outside_extrapolate_from_the_nearest_cell)
{
    const Lattice lattice(Size(30, 20), 3, 2);
    const CellPoint point = lattice.locate(Point2d(-6, 25));
    EXPECT_EQ(point.cell, 3);
    EXPECT_LT(cv::norm(lattice.referencePoint(point) - Point2d(-6, 25)), 1e-12);
    EXPECT_EQ(lattice.locate(Point2d(1e6, -1e6)).cell, 2);
}

TEST(Gcpw_Lattice, neighbours_share_a_corner_and_know_each_other)
{
    const Lattice lattice(Size(50, 40), 5, 4);
    std::array<int, 8> near;
    std::array<int, 8> back;
    EXPECT_EQ(lattice.neighbours(0, near), 3);
    EXPECT_EQ(lattice.neighbours(2, near), 5);
    EXPECT_EQ(lattice.neighbours(6, near), 8);
    for (int cell = 0; cell < lattice.cellCount(); ++cell)
    {
        const int count = lattice.neighbours(cell, near);
        EXPECT_TRUE(std::is_sorted(near.begin(), near.begin() + count));
        for (int k = 0; k < count; ++k)
        {
            EXPECT_NE(near[k], cell);
            EXPECT_LE(std::abs(near[k] % 5 - cell % 5), 1);
            EXPECT_LE(std::abs(near[k] / 5 - cell / 5), 1);
            const int count_back = lattice.neighbours(near[k], back);
            EXPECT_EQ(std::count(back.begin(), back.begin() + count_back, cell), 1);
        }
    }
}

TEST(Gcpw_Lattice, an_empty_image_or_no_cells_are_refused)
{
    EXPECT_THROW(Lattice(Size(0, 10), 2, 2), cv::Exception);
    EXPECT_THROW(Lattice(Size(10, 0), 2, 2), cv::Exception);
    EXPECT_THROW(Lattice(Size(10, 10), 0, 2), cv::Exception);
    EXPECT_THROW(Lattice(Size(10, 10), 2, 0), cv::Exception);
}

TEST(Gcpw_Lattice, any_position_has_a_cell_of_the_lattice)
{
    const Lattice lattice(Size(50, 40), 5, 4);
    const double values[] = {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity(), 1e300, 3e10, -3e10, -1e300,
                             -std::numeric_limits<double>::infinity()};
    for (const double value : values)
    {
        const int near = value > 0 ? 4 : 0; // of NaN: the first
        EXPECT_EQ(lattice.locate(Point2d(value, 0)).cell, near) << value;
        EXPECT_EQ(lattice.locate(Point2d(0, value)).cell, value > 0 ? 15 : 0) << value;
    }
}

}} // namespace
