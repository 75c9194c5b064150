// Part of the GCPW module for OpenCV. Licence: Apache-2.0 (see LICENSE).
#include "test_precomp.hpp"

#include "seeded.hpp"
#include "energy/color_smoothness_term.hpp"

namespace opencv_test { namespace {

using namespace cv::gcpw;

const Lattice LATTICE(Size(80, 60), 4, 3);
const double WEIGHT = 0.7;

ColorGrid randomGrid(uint64_t seed)
{
    RNG rng = seeded(seed);
    ColorGrid grid(LATTICE);
    for (int cell = 0; cell < LATTICE.cellCount(); ++cell)
        for (ChannelAffine& map : grid.quad(cell))
            map = {rng.uniform(0.6, 1.4), rng.uniform(-0.15, 0.15)};
    return grid;
}

double energyOf(const ColorGrid& grid)
{
    ColorSystem system({grid.lattice()}, {false});
    addColorSmoothness(0, grid.lattice(), WEIGHT, system);
    return system.regularizationEnergy({grid});
}

TEST(Gcpw_ColorSmoothnessTerm, it_is_equation_colorterm)
{
    const ColorGrid grid = randomGrid(1);
    double expected = 0;
    for (int i = 0; i < LATTICE.cellCount(); ++i)
        for (int j = 0; j < LATTICE.cellCount(); ++j)
        {
            if (i == j || std::abs(i % 4 - j % 4) > 1 || std::abs(i / 4 - j / 4) > 1)
                continue;
            for (int c = 0; c < CHANNELS; ++c)
                for (int n = 0; n <= 10; ++n)
                {
                    const double x = 0.1 * n;
                    const double d = grid.quad(i)[c].gain * x + grid.quad(i)[c].bias - grid.quad(j)[c].gain * x -
                                     grid.quad(j)[c].bias;
                    expected += WEIGHT * d * d;
                }
        }
    EXPECT_NEAR(energyOf(grid), expected, 1e-9 * expected);
}

TEST(Gcpw_ColorSmoothnessTerm, it_is_zero_where_all_quads_agree)
{
    ColorGrid grid(LATTICE);
    EXPECT_EQ(energyOf(grid), 0);
    for (int cell = 0; cell < LATTICE.cellCount(); ++cell)
        grid.quad(cell)[1] = {1.3, -0.1};
    EXPECT_NEAR(energyOf(grid), 0, 1e-15);
    grid.quad(5)[1].bias += 0.01;
    EXPECT_GT(energyOf(grid), 1e-4);
}

TEST(Gcpw_ColorSmoothnessTerm, the_same_change_of_all_quads_is_not_felt)
{
    ColorGrid grid = randomGrid(2);
    const double before = energyOf(grid);
    for (int cell = 0; cell < LATTICE.cellCount(); ++cell)
        for (ChannelAffine& map : grid.quad(cell))
        {
            map.gain += 0.3;
            map.bias -= 0.07;
        }
    EXPECT_NEAR(energyOf(grid), before, 1e-9 * before);
}

TEST(Gcpw_ColorSmoothnessTerm, a_single_quad_has_nobody_to_agree_with)
{
    ColorGrid grid(Lattice(Size(10, 10), 1, 1));
    grid.quad(0)[0] = {2, 1};
    EXPECT_EQ(energyOf(grid), 0);
}

TEST(Gcpw_ColorSmoothnessTerm, it_acts_on_the_image_it_is_given)
{
    ColorSystem system({LATTICE, LATTICE}, {false, false});
    addColorSmoothness(1, LATTICE, WEIGHT, system);
    EXPECT_EQ(system.regularizationEnergy({randomGrid(3), ColorGrid(LATTICE)}), 0);
    EXPECT_GT(system.regularizationEnergy({ColorGrid(LATTICE), randomGrid(3)}), 0);
}

}} // namespace
