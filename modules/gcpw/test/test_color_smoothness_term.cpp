// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#include "test_precomp.hpp"

#include "seeded.hpp"
#include "energy/color_prior_term.hpp"
#include "energy/color_smoothness_term.hpp"
#include "recording_equations.hpp"

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
    return ColorSmoothnessTerm(0, grid.lattice(), WEIGHT).evaluate({{MeshGrid(grid.lattice()), grid}});
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
    const ColorSmoothnessTerm term(1, LATTICE, WEIGHT);
    const MeshGrid mesh(LATTICE);
    EXPECT_EQ(term.evaluate({{mesh, randomGrid(3)}, {mesh, ColorGrid(LATTICE)}}), 0);
    EXPECT_GT(term.evaluate({{mesh, ColorGrid(LATTICE)}, {mesh, randomGrid(3)}}), 0);
}

TEST(Gcpw_ColorSmoothnessTerm, what_it_adds_is_its_energy)
{
    ColorSmoothnessTerm term(0, LATTICE, WEIGHT);
    const ColorGrid grid = randomGrid(4);
    RecordingEquations equations({LATTICE});
    const double energy = term.linearize({{MeshGrid(LATTICE), grid}}, equations);
    double sum = 0;
    for (const RecordingEquations::Difference& item : equations.differences)
        for (int c = 0; c < CHANNELS; ++c)
        {
            const double gain = grid.quad(item.a.cell)[c].gain - grid.quad(item.b.cell)[c].gain;
            const double bias = grid.quad(item.a.cell)[c].bias - grid.quad(item.b.cell)[c].bias;
            sum += item.block.gain_gain * gain * gain + 2 * item.block.gain_bias * gain * bias + item.block.bias_bias * bias * bias;
        }
    EXPECT_GT(energy, 0);
    EXPECT_NEAR(sum, energy, 1e-9 * energy);
}

TEST(Gcpw_ColorPriorTerm, what_it_adds_is_its_energy)
{
    ColorPriors priors(LATTICE.cellCount());
    for (size_t cell = 0; cell < priors.size(); cell += 2)
        priors[cell] = {0.1 * static_cast<double>(cell + 1), randomGrid(5).quad(static_cast<int>(cell))};
    ColorPriorTerm term(0, priors);
    const ColorGrid grid = randomGrid(6);
    RecordingEquations equations({LATTICE});
    const double energy = term.linearize({{MeshGrid(LATTICE), grid}}, equations);
    EXPECT_EQ(equations.priors.size(), priors.size() / 2);
    double sum = 0;
    for (const RecordingEquations::Prior& item : equations.priors)
        for (int c = 0; c < CHANNELS; ++c)
        {
            const double gain = grid.quad(item.quad.cell)[c].gain - item.reference[c].gain;
            const double bias = grid.quad(item.quad.cell)[c].bias - item.reference[c].bias;
            sum += item.weight * (gain * gain + bias * bias);
        }
    EXPECT_GT(energy, 0);
    EXPECT_NEAR(sum, energy, 1e-9 * energy);
    ColorGrid there(LATTICE);
    for (size_t cell = 0; cell < priors.size(); cell += 2)
        there.quad(static_cast<int>(cell)) = priors[cell].reference;
    EXPECT_EQ(term.evaluate({{MeshGrid(LATTICE), there}}), 0);
}

}} // namespace
