// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#include "test_precomp.hpp"

#include "model/color_grid.hpp"

namespace opencv_test { namespace {

using namespace cv::gcpw;

const Lattice LATTICE(Size(80, 60), 4, 3);

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
    for (const ChannelAffine& map : grid.quad(5))
    {
        EXPECT_EQ(map.gain, 1);
        EXPECT_EQ(map.bias, 0);
    }
    grid.quad(5)[1].gain = 1.5;
    EXPECT_FALSE(grid.isIdentity());
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
