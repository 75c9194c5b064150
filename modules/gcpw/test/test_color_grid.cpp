// Part of the GCPW module for OpenCV. Licence: Apache-2.0 (see LICENSE).
#include "test_precomp.hpp"

#include "model/color_grid.hpp"
#include "seeded.hpp"

namespace opencv_test { namespace {

using namespace cv::gcpw;

const Lattice LATTICE(Size(80, 60), 4, 3); // cells of 20 x 20 px, centres at 9.5, 29.5, ..

/// Gains that are linear in the position of the quad's centre, biases that are linear in another direction.
ColorGrid linearGrid()
{
    ColorGrid grid(LATTICE);
    for (int cell = 0; cell < LATTICE.cellCount(); ++cell)
        for (int c = 0; c < CHANNELS; ++c)
        {
            grid.quad(cell)[c].gain = 1 + 0.1 * (cell % 4) - 0.02 * (cell / 4) + c;
            grid.quad(cell)[c].bias = 0.03 * (cell / 4) - 0.1 * c;
        }
    return grid;
}

TEST(Gcpw_ColorGrid, a_fresh_grid_changes_no_color)
{
    ColorGrid grid(LATTICE);
    EXPECT_TRUE(grid.isIdentity());
    for (const ChannelAffine& map : grid.at(Point2d(33, 21)))
    {
        EXPECT_EQ(map.gain, 1);
        EXPECT_EQ(map.bias, 0);
    }
    grid.quad(5)[1].gain = 1.5;
    EXPECT_FALSE(grid.isIdentity());
}

TEST(Gcpw_ColorGrid, quad_centres_have_the_quads_own_color)
{
    const ColorGrid grid = linearGrid();
    for (int cell = 0; cell < LATTICE.cellCount(); ++cell)
    {
        const Point2d centre(20 * (cell % 4) + 9.5, 20 * (cell / 4) + 9.5);
        for (int c = 0; c < CHANNELS; ++c)
        {
            EXPECT_NEAR(grid.at(centre)[c].gain, grid.quad(cell)[c].gain, 1e-12);
            EXPECT_NEAR(grid.at(centre)[c].bias, grid.quad(cell)[c].bias, 1e-12);
        }
    }
}

TEST(Gcpw_ColorGrid, between_centres_it_is_bilinear)
{
    const ColorGrid grid = linearGrid();
    RNG rng = seeded(1);
    for (int i = 0; i < 200; ++i)
    {
        const Point2d p(rng.uniform(9.5, 69.5), rng.uniform(9.5, 49.5));
        const double col = (p.x - 9.5) / 20;
        const double row = (p.y - 9.5) / 20;
        const ColorGrid::Quad color = grid.at(p);
        for (int c = 0; c < CHANNELS; ++c)
        {
            EXPECT_NEAR(color[c].gain, 1 + 0.1 * col - 0.02 * row + c, 1e-12);
            EXPECT_NEAR(color[c].bias, 0.03 * row - 0.1 * c, 1e-12);
        }
    }
}

TEST(Gcpw_ColorGrid, beyond_the_outer_centres_it_is_constant)
{
    const ColorGrid grid = linearGrid();
    const auto same = [&](Point2d p, Point2d q)
    {
        for (int c = 0; c < CHANNELS; ++c)
        {
            EXPECT_NEAR(grid.at(p)[c].gain, grid.at(q)[c].gain, 1e-12);
            EXPECT_NEAR(grid.at(p)[c].bias, grid.at(q)[c].bias, 1e-12);
        }
    };
    same(Point2d(-0.5, 30), Point2d(9.5, 30));
    same(Point2d(79.5, 30), Point2d(69.5, 30));
    same(Point2d(30, -100), Point2d(30, 9.5));
    same(Point2d(30, 1000), Point2d(30, 49.5));
    same(Point2d(-1, -1), Point2d(9.5, 9.5));
}

TEST(Gcpw_ColorGrid, a_single_quad_is_one_color_everywhere)
{
    ColorGrid grid(Lattice(Size(10, 10), 1, 1));
    grid.quad(0)[2] = {0.7, 0.1};
    for (const Point2d& p : {Point2d(0, 0), Point2d(9, 4), Point2d(4.5, 4.5)})
    {
        EXPECT_NEAR(grid.at(p)[2].gain, 0.7, 1e-12);
        EXPECT_NEAR(grid.at(p)[2].bias, 0.1, 1e-12);
    }
}

TEST(Gcpw_ColorGrid, as_a_mat_gains_come_before_biases)
{
    const Mat mat = linearGrid().toMat();
    ASSERT_EQ(mat.type(), CV_32FC(6));
    ASSERT_EQ(mat.size(), Size(4, 3));
    const float* cell = mat.ptr<float>(2) + 6 * 1; // row 2, column 1
    for (int c = 0; c < CHANNELS; ++c)
    {
        EXPECT_FLOAT_EQ(cell[c], static_cast<float>(1 + 0.1 - 0.04 + c));
        EXPECT_FLOAT_EQ(cell[3 + c], static_cast<float>(0.06 - 0.1 * c));
    }
}

TEST(Gcpw_ColorGrid, mixing_goes_straight_from_one_to_the_other)
{
    const ColorGrid a(LATTICE);
    const ColorGrid b = linearGrid();
    for (const double share : {0.0, 0.25, 1.0})
    {
        const ColorGrid between = mixed(a, b, share);
        for (int cell = 0; cell < LATTICE.cellCount(); ++cell)
        {
            EXPECT_NEAR(between.quad(cell)[1].gain, (1 - share) + share * b.quad(cell)[1].gain, 1e-12);
            EXPECT_NEAR(between.quad(cell)[1].bias, share * b.quad(cell)[1].bias, 1e-12);
        }
    }
}

TEST(Gcpw_ColorGrid, reading_changes_nothing)
{
    ColorGrid grid(LATTICE);
    double sum = 0;
    for (int cell = 0; cell < LATTICE.cellCount(); ++cell)
        sum += grid.quad(cell)[0].gain;
    EXPECT_EQ(sum, LATTICE.cellCount());
    EXPECT_TRUE(grid.isIdentity());
    grid.quad(11)[2].bias = 1e-9;
    EXPECT_FALSE(grid.isIdentity());
    grid.quad(11)[2].bias = 0;
    EXPECT_TRUE(grid.isIdentity());
}

}} // namespace
