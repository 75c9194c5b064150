// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#include "test_precomp.hpp"

#include "bent_mesh.hpp"
#include "term_laws.hpp"
#include "energy/straightness_term.hpp"

namespace opencv_test { namespace {

using namespace cv::gcpw;

const Lattice LATTICE(Size(80, 60), 4, 3);
const double WEIGHT = 3;
const double STEP = 4;
const int COLUMNS = 2 * LATTICE.vertexCount();
const std::vector<Curve> LINES = {{Point2d(5, 8), Point2d(75, 50)}, {Point2d(30, 2), Point2d(34, 57)}};

MeshGrid rough()
{
    return bentMesh(LATTICE, 2, 1, Point2d(200, 100));
}

TermState deformed()
{
    return TermState({bentMesh(LATTICE, 4, 2, Point2d(190, 120))});
}

double energyOf(const MeshGrid& before, const MeshGrid& after, const std::vector<Curve>& curves = LINES)
{
    return StraightnessTerm(0, before, curves, STEP, WEIGHT).evaluate({{after, ColorGrid(LATTICE)}});
}

/// The mesh displaced by a function of its vertices' positions.
template <typename Displacement>
MeshGrid displaced(const MeshGrid& mesh, Displacement displacement)
{
    MeshGrid result = mesh;
    for (Point2d& vertex : result.vertices())
        vertex += displacement(vertex);
    return result;
}

TEST(Gcpw_StraightnessTerm, it_is_zero_at_the_rough_alignment_whatever_its_shape)
{
    EXPECT_NEAR(energyOf(rough(), rough()), 0, 1e-12);
}

TEST(Gcpw_StraightnessTerm, lines_may_shift_turn_and_stretch)
{
    const MeshGrid flat(LATTICE, Point2d(30, 40));
    EXPECT_NEAR(energyOf(flat, displaced(flat, [](Point2d) { return Point2d(12, -7); })), 0, 1e-9);
    EXPECT_NEAR(energyOf(flat, affineMesh(flat, Matx22d(1, -0.2, 0.2, 1), Point2d(3, 4))), 0, 1e-9);
    EXPECT_NEAR(energyOf(flat, affineMesh(flat, Matx22d(1.3, 0.1, -0.2, 0.8), Point2d(3, 4))), 0, 1e-9);
}

TEST(Gcpw_StraightnessTerm, each_line_may_go_its_own_way)
{
    // The left line moves right, the right one up: straight lines both, though the mesh between them is bent.
    const MeshGrid flat((Lattice(Size(80, 60), 4, 3)));
    const MeshGrid bent = displaced(flat, [](Point2d p) { return p.x < 25 ? Point2d(5, 0) : Point2d(0, -4); });
    EXPECT_NEAR(energyOf(flat, bent, {{Point2d(10, 5), Point2d(10, 55)}, {Point2d(60, 5), Point2d(60, 55)}}), 0, 1e-9);
    EXPECT_GT(energyOf(flat, bent, {{Point2d(5, 30), Point2d(75, 30)}}), 1);
}

TEST(Gcpw_StraightnessTerm, a_bend_of_one_pixel_counts_as_its_squares)
{
    // Displacement across a horizontal line that is +1 at every second vertex and -1 between.
    const MeshGrid flat((Lattice(Size(80, 60), 4, 3)));
    const MeshGrid bent = displaced(flat, [](Point2d p) { return Point2d(0, cvRound((p.x + 0.5) / 20) % 2 ? 1 : -1); });
    const std::vector<Curve> line = {{Point2d(-0.5, 30), Point2d(79.5, 30)}};
    double expected = 0; // the zigzag has no slope and hardly a mean: its squares remain
    double mean = 0;
    const int count = 21;
    std::vector<double> zigzag;
    for (int k = 0; k < count; ++k)
    {
        const double u = std::fmod(k * 4.0, 40.0) / 20;
        zigzag.push_back(u < 1 ? -1 + 2 * u : 3 - 2 * u);
        mean += zigzag.back() / count;
    }
    for (const double z : zigzag)
        expected += WEIGHT * (z - mean) * (z - mean);
    EXPECT_NEAR(energyOf(flat, bent, line), expected, 1e-6);
}

TEST(Gcpw_StraightnessTerm, what_the_base_warper_bent_may_shift_too)
{
    const MeshGrid flat(LATTICE);
    const MeshGrid bowed = displaced(flat, [](Point2d p) { return Point2d(0, 0.004 * (p.x - 40) * (p.x - 40)); });
    const MeshGrid shifted = displaced(bowed, [](Point2d) { return Point2d(0, 6); });
    const std::vector<Curve> line = {{Point2d(10, 30), Point2d(70, 30)}};
    EXPECT_LT(energyOf(bowed, shifted, line), 0.01 * energyOf(bowed, displaced(flat, [](Point2d) { return Point2d(0, 6); }), line));
}

TEST(Gcpw_StraightnessTerm, energy_equals_the_sum_of_the_accumulated_groups)
{
    expectEnergyIsSumOfRows(linearizing(std::make_shared<StraightnessTerm>(0, rough(), LINES, STEP, WEIGHT)), deformed());
}

TEST(Gcpw_StraightnessTerm, jacobian_equals_finite_differences)
{
    const LinearizeTerm accumulate = linearizing(std::make_shared<StraightnessTerm>(0, rough(), LINES, STEP, WEIGHT));
    expectExactlyQuadratic(accumulate, deformed(), 0, COLUMNS, 2.0, 1e-9);
    expectGradientIsSlope(accumulate, deformed(), 0, COLUMNS, 1e-3, 1e-7);
}

TEST(Gcpw_StraightnessTerm, curves_without_length_or_outside_the_image_have_no_rows)
{
    const std::vector<Curve> useless = {{}, {Point2d(3, 3)}, {Point2d(3, 3), Point2d(3, 3)}, {Point2d(3, 3), Point2d(4, 3)},
                                        {Point2d(200, 10), Point2d(300, 10)}};
    StraightnessTerm term(0, rough(), useless, STEP, WEIGHT);
    RecordingEquations equations({LATTICE});
    EXPECT_EQ(term.linearize(deformed().state(), equations), 0);
    EXPECT_TRUE(equations.empty());
}

}} // namespace
