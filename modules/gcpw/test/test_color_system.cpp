// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#include "test_precomp.hpp"

#include <Eigen/LU>
#include "solver/color_system.hpp"
#include "random_problem.hpp"
#include "recording_equations.hpp"

namespace opencv_test { namespace {

using namespace cv::gcpw;

const Lattice FIRST(Size(60, 40), 3, 2);
const Lattice SECOND(Size(40, 40), 2, 2);
const ColorBlock LINK{3.85, 5.5, 11}; ///< the form of eq. colorterm

/// Grids with colours of no pattern.
std::vector<ColorGrid> randomGrids(uint64_t seed)
{
    RNG rng = seeded(seed);
    std::vector<ColorGrid> grids = {ColorGrid(FIRST), ColorGrid(SECOND)};
    for (ColorGrid& grid : grids)
        for (int cell = 0; cell < grid.lattice().cellCount(); ++cell)
            for (ChannelAffine& map : grid.quad(cell))
                map = {rng.uniform(0.6, 1.4), rng.uniform(-0.15, 0.15)};
    return grids;
}

Eigen::VectorXd stacked(const std::vector<ColorGrid>& grids)
{
    std::vector<double> all;
    for (const ColorGrid& grid : grids)
        for (int cell = 0; cell < grid.lattice().cellCount(); ++cell)
            for (const ChannelAffine& map : grid.quad(cell))
                all.insert(all.end(), {map.gain, map.bias});
    return Eigen::Map<Eigen::VectorXd>(all.data(), static_cast<Eigen::Index>(all.size()));
}

/// Everything a ColorSystem was told, as a function of the colours. Samples are linearised at `now`.
struct Told
{
    struct Pull
    {
        QuadId quad;
        double weight;
    };
    std::vector<std::pair<QuadId, QuadId>> links;
    std::vector<Pull> priors;
    RecordingEquations samples{{FIRST, SECOND}};
    std::vector<ColorGrid> now;

    double regular(const Eigen::VectorXd& x) const
    {
        double energy = 0;
        const int offset = samples.meshColumns();
        for (int c = 0; c < 3; ++c)
        {
            for (const auto& link : links)
            {
                const int a = samples.colorColumn(link.first, 2 * c) - offset;
                const int b = samples.colorColumn(link.second, 2 * c) - offset;
                const double g = x[a] - x[b];
                const double h = x[a + 1] - x[b + 1];
                energy += LINK.gain_gain * g * g + 2 * LINK.gain_bias * g * h + LINK.bias_bias * h * h;
            }
            for (const Pull& prior : priors)
            {
                const int a = samples.colorColumn(prior.quad, 2 * c) - offset;
                energy += prior.weight * ((x[a] - 1) * (x[a] - 1) + x[a + 1] * x[a + 1]);
            }
        }
        return energy;
    }

    double total(const Eigen::VectorXd& x) const
    {
        const Eigen::Index n = x.size();
        const Eigen::VectorXd d = x - stacked(now);
        return samples.energy() + 2 * samples.gradient().tail(n).dot(d) +
               d.dot(samples.matrix().bottomRightCorner(n, n) * d) + regular(x);
    }
};

/// Samples that compare two quads of the first image with two of the second.
void tellCrossSamples(ColorSystem& system, Told& told, uint64_t seed)
{
    RNG rng = seeded(seed);
    for (int k = 0; k < 2; ++k)
    {
        const QuadId a{0, 4 - k};
        const QuadId b{1, 2 + k};
        const RandomSamples samples = randomSamples(rng, 10);
        told.samples.addPhotometric(a, samples.own);
        told.samples.addCross(a, b, samples.target);
        system.addSamples(a, samples.own, told.now[0].quad(a.cell));
        system.addCross(a, told.now[0].quad(a.cell), b, told.now[1].quad(b.cell), samples.target);
    }
}

/// Links between neighbours, priors on two quads, samples on all but those two.
Told tell(ColorSystem& system, uint64_t seed)
{
    Told told;
    told.now = randomGrids(seed);
    RNG rng = seeded(seed + 100);
    const Lattice lattices[2] = {FIRST, SECOND};
    for (int image = 0; image < 2; ++image)
        for (int cell = 0; cell < lattices[image].cellCount(); ++cell)
        {
            std::array<int, 8> near;
            const int count = lattices[image].neighbours(cell, near);
            for (int k = 0; k < count; ++k)
                if (near[k] > cell)
                {
                    told.links.push_back({{image, cell}, {image, near[k]}});
                    system.addColorDifference({image, cell}, {image, near[k]}, LINK);
                }
            if (cell == 1)
            {
                told.priors.push_back({{image, cell}, 0.8});
                system.addColorPrior({image, cell}, 0.8, ColorGrid::Quad());
                continue;
            }
            const PhotometricBlock block = randomPhotometricBlock(rng, 12);
            told.samples.addPhotometric({image, cell}, block);
            system.addSamples({image, cell}, block, told.now[image].quad(cell));
        }
    return told;
}

/// Largest slope of the energy along any colour unknown in [first, last).
double steepest(const Told& told, Eigen::VectorXd x, Eigen::Index first, Eigen::Index last)
{
    double worst = 0;
    const double step = 1e-3; // the energy is quadratic: central differences are exact
    for (Eigen::Index k = first; k < last; ++k)
    {
        const double before = x[k];
        x[k] = before + step;
        const double high = told.total(x);
        x[k] = before - step;
        const double low = told.total(x);
        x[k] = before;
        worst = std::max(worst, std::abs(high - low) / (2 * step));
    }
    return worst;
}

TEST(Gcpw_ColorSystem, at_its_solution_the_energy_is_flat)
{
    ColorSystem system({FIRST, SECOND}, {false, false});
    const Told told = tell(system, 1);
    std::vector<ColorGrid> grids = randomGrids(2);
    const double before = steepest(told, stacked(grids), 0, stacked(grids).size());
    ASSERT_EQ(system.solve(grids), SolveStatus::Solved);
    EXPECT_LT(steepest(told, stacked(grids), 0, stacked(grids).size()), 1e-3 * before);
}

TEST(Gcpw_ColorSystem, images_that_are_compared_are_solved_together)
{
    for (const bool first_fixed : {false, true})
    {
        ColorSystem system({FIRST, SECOND}, {first_fixed, false});
        Told told = tell(system, 21);
        std::vector<ColorGrid> apart = randomGrids(22);
        std::vector<ColorGrid> together = apart;
        const Eigen::VectorXd start = stacked(apart);
        ASSERT_EQ(system.solve(apart), SolveStatus::Solved);
        tellCrossSamples(system, told, 23);
        ASSERT_EQ(system.solve(together), SolveStatus::Solved);
        const Eigen::VectorXd x = stacked(together);
        const Eigen::Index first = first_fixed ? 6 * FIRST.cellCount() : 0;
        EXPECT_GT((stacked(apart) - x).tail(x.size() - first).norm(), 0.01) << "the comparison says nothing";
        EXPECT_LT(steepest(told, x, first, x.size()), 1e-3 * steepest(told, start, first, x.size()));
        EXPECT_EQ(x.head(first), start.head(first));
    }
}

TEST(Gcpw_ColorSystem, the_solution_does_not_depend_on_the_start)
{
    ColorSystem system({FIRST, SECOND}, {false, false});
    tell(system, 3);
    std::vector<ColorGrid> one = randomGrids(4);
    std::vector<ColorGrid> other = {ColorGrid(FIRST), ColorGrid(SECOND)};
    ASSERT_EQ(system.solve(one), SolveStatus::Solved);
    ASSERT_EQ(system.solve(other), SolveStatus::Solved);
    EXPECT_LT((stacked(one) - stacked(other)).norm(), 1e-3);
}

TEST(Gcpw_ColorSystem, a_fixed_grid_keeps_its_colors_and_the_other_is_best_beside_it)
{
    ColorSystem system({FIRST, SECOND}, {true, false});
    const Told told = tell(system, 5);
    std::vector<ColorGrid> grids = randomGrids(6);
    const Eigen::VectorXd before = stacked(grids);
    ASSERT_EQ(system.solve(grids), SolveStatus::Solved);
    const Eigen::VectorXd after = stacked(grids);
    const Eigen::Index fixed = 6 * FIRST.cellCount();
    EXPECT_EQ(before.head(fixed), after.head(fixed));
    EXPECT_GT((before - after).norm(), 0.01);
    EXPECT_LT(steepest(told, after, fixed, after.size()), 1e-3 * steepest(told, before, fixed, after.size()));
}

TEST(Gcpw_ColorSystem, without_samples_prior_and_links_lead_to_the_identity)
{
    ColorSystem system({FIRST, SECOND}, {false, false});
    const Told told = tell(system, 7);
    system.clearSamples();
    std::vector<ColorGrid> grids = randomGrids(8);
    ASSERT_EQ(system.solve(grids), SolveStatus::Solved);
    EXPECT_LT((stacked(grids) - stacked({ColorGrid(FIRST), ColorGrid(SECOND)})).norm(), 1e-3);
}

TEST(Gcpw_ColorSystem, priors_of_one_quad_add_up)
{
    ColorSystem system({FIRST}, {false});
    ColorGrid::Quad low;
    ColorGrid::Quad high;
    low[0] = {0.5, -0.1};
    high[0] = {1.1, 0.2};
    for (int cell = 0; cell < FIRST.cellCount(); ++cell)
    {
        system.addColorPrior({0, cell}, 1, low);
        system.addColorPrior({0, cell}, 2, high);
    }
    std::vector<ColorGrid> grids(1, ColorGrid(FIRST));
    ASSERT_EQ(system.solve(grids), SolveStatus::Solved);
    EXPECT_NEAR(grids[0].quad(0)[0].gain, 0.9, 1e-4);
    EXPECT_NEAR(grids[0].quad(0)[0].bias, 0.1, 1e-4);
}

TEST(Gcpw_ColorSystem, set_to_zero_it_forgets_everything)
{
    ColorSystem system({FIRST, SECOND}, {false, false});
    tell(system, 9);
    system.setZero();
    std::vector<ColorGrid> grids = randomGrids(10);
    EXPECT_EQ(system.solve(grids), SolveStatus::NotPositiveDefinite) << "nothing determines them";
    const Told told = tell(system, 9);
    ASSERT_EQ(system.solve(grids), SolveStatus::Solved);
    ColorSystem fresh({FIRST, SECOND}, {false, false});
    tell(fresh, 9);
    std::vector<ColorGrid> same = randomGrids(10);
    ASSERT_EQ(fresh.solve(same), SolveStatus::Solved);
    EXPECT_EQ(stacked(grids), stacked(same));
}

TEST(Gcpw_ColorSystem, colors_that_nothing_holds_are_refused_and_left_alone)
{
    ColorSystem system({FIRST, SECOND}, {false, false});
    std::vector<ColorGrid> grids = randomGrids(11);
    const Eigen::VectorXd before = stacked(grids);
    EXPECT_EQ(system.solve(grids), SolveStatus::NotPositiveDefinite);
    EXPECT_EQ(stacked(grids), before);
    tell(system, 12);
    PhotometricBlock broken;
    broken.color_color[1][0] = std::numeric_limits<double>::quiet_NaN();
    system.addSamples({0, 2}, broken, grids[0].quad(2));
    EXPECT_EQ(system.solve(grids), SolveStatus::NotPositiveDefinite);
    EXPECT_EQ(stacked(grids), before);
}

TEST(Gcpw_ColorSystem, eliminating_equals_the_dense_schur_complement)
{
    ColorSystem system({FIRST, SECOND}, {false, false});
    Told told;
    const std::vector<ColorGrid> now = randomGrids(13);
    const QuadId quad{0, 1};
    const QuadId neighbours[2] = {{0, 0}, {0, 2}};
    for (const QuadId& other : neighbours)
        system.addColorDifference(quad, other, LINK);
    system.addColorPrior(quad, 0.6, ColorGrid::Quad());
    RNG rng = seeded(14);
    const PhotometricBlock block = randomPhotometricBlock(rng, 9);

    // All fourteen unknowns of the quad, its neighbours' colours fixed where they are.
    Eigen::Matrix<double, 14, 14> matrix = Eigen::Matrix<double, 14, 14>::Zero();
    Eigen::Matrix<double, 14, 1> gradient = Eigen::Matrix<double, 14, 1>::Zero();
    RecordingEquations one({Lattice(Size(10, 10), 1, 1)});
    one.addPhotometric({0, 0}, block);
    matrix = one.matrix();
    gradient = one.gradient();
    Eigen::Matrix2d link;
    link << LINK.gain_gain, LINK.gain_bias, LINK.gain_bias, LINK.bias_bias;
    for (int c = 0; c < 3; ++c)
    {
        const int k = one.colorColumn({0, 0}, 2 * c);
        const ChannelAffine mine = now[0].quad(quad.cell)[c];
        for (const QuadId& other : neighbours)
        {
            const ChannelAffine its = now[0].quad(other.cell)[c];
            matrix.block<2, 2>(k, k) += link;
            gradient.segment<2>(k) += link * Eigen::Vector2d(mine.gain - its.gain, mine.bias - its.bias);
        }
        matrix.block<2, 2>(k, k) += 0.6 * Eigen::Matrix2d::Identity();
        gradient.segment<2>(k) += 0.6 * Eigen::Vector2d(mine.gain - 1, mine.bias);
    }
    const Eigen::MatrixXd lift = matrix.topRightCorner<8, 6>() * matrix.bottomRightCorner<6, 6>().inverse();
    const Eigen::MatrixXd schur = matrix.topLeftCorner<8, 8>() - lift * matrix.bottomLeftCorner<6, 8>();
    const Eigen::VectorXd reduced = gradient.head<8>() - lift * gradient.tail<6>();

    PhotometricBlock eliminated = block;
    system.eliminate(quad, now, eliminated);
    for (int i = 0; i < 8; ++i)
    {
        EXPECT_NEAR(eliminated.mesh_gradient[i], reduced[one.meshColumn({0, 0}, i)], 1e-9);
        for (int j = i; j < 8; ++j)
            EXPECT_NEAR(eliminated.mesh_mesh[i][j], schur(one.meshColumn({0, 0}, i), one.meshColumn({0, 0}, j)), 1e-9);
    }
}

TEST(Gcpw_ColorSystem, a_color_that_nothing_holds_is_not_eliminated)
{
    ColorSystem system({FIRST, SECOND}, {false, false});
    RNG rng = seeded(15);
    PhotometricBlock block;
    block.mesh_gradient = randomRow(rng);
    PhotometricBlock eliminated = block;
    system.eliminate({0, 3}, randomGrids(16), eliminated);
    EXPECT_EQ(eliminated.mesh_gradient, block.mesh_gradient);
}

}} // namespace
