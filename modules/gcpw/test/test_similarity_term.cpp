// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#include "test_precomp.hpp"

#include "bent_mesh.hpp"
#include "term_laws.hpp"
#include "energy/similarity_term.hpp"

namespace opencv_test { namespace {

using namespace cv::gcpw;

const Lattice LATTICE(Size(80, 60), 4, 3);
const double WEIGHT = 0.5;
const int COLUMNS = 2 * LATTICE.vertexCount();

MeshGrid rough()
{
    return bentMesh(LATTICE, 3, 1, Point2d(200, 100));
}

TermState deformed()
{
    return TermState({bentMesh(LATTICE, 4, 2, Point2d(190, 120))});
}

LinearizeTerm accumulateSimilarity(const SimilarityTerm& term)
{
    return linearizing(std::make_shared<SimilarityTerm>(term));
}

State stateOf(const MeshGrid& mesh)
{
    return {{mesh, ColorGrid(LATTICE)}};
}

/// Equation st1 as it stands: how far v1 is from where v2, v3 and its rough coordinates (u, v) put it, squared.
double triangleEnergy(const Point2d (&before)[3], const Point2d (&after)[3])
{
    const auto rotated = [](Point2d p) { return Point2d(p.y, -p.x); };
    const Point2d edge = before[2] - before[1];
    const Point2d offset = before[0] - before[1];
    const double u = offset.dot(edge) / edge.dot(edge);
    const double v = offset.dot(rotated(edge)) / edge.dot(edge);
    const Point2d now = after[2] - after[1];
    const Point2d r = after[0] - (after[1] + u * now + v * rotated(now));
    return r.dot(r);
}

TEST(Gcpw_SimilarityTerm, it_is_zero_at_the_rough_mesh)
{
    SimilarityTerm term(0, rough(), WEIGHT);
    RecordingEquations equations({LATTICE});
    EXPECT_NEAR(term.linearize(stateOf(rough()), equations), 0, 1e-12);
    EXPECT_EQ(equations.blocks.size(), static_cast<size_t>(LATTICE.cellCount()));
    EXPECT_LT(equations.gradient().norm(), 1e-9);
    EXPECT_NEAR(term.evaluate(stateOf(rough())), 0, 1e-12);
}

TEST(Gcpw_SimilarityTerm, it_does_not_feel_a_similarity_of_the_whole_mesh)
{
    SimilarityTerm term(0, rough(), WEIGHT);
    for (const double angle : {0.3, 2.0, -1.2})
        for (const double scale : {0.5, 1.0, 3.0})
        {
            const Matx22d turn(scale * std::cos(angle), -scale * std::sin(angle), scale * std::sin(angle),
                               scale * std::cos(angle));
            EXPECT_NEAR(term.evaluate(stateOf(affineMesh(rough(), turn, Point2d(-300, 70)))), 0, 1e-9);
        }
}

TEST(Gcpw_SimilarityTerm, it_feels_shear_stretch_and_mirror)
{
    SimilarityTerm term(0, rough(), WEIGHT);
    EXPECT_GT(term.evaluate(stateOf(affineMesh(rough(), Matx22d(1, 0.1, 0, 1), Point2d()))), 1);
    EXPECT_GT(term.evaluate(stateOf(affineMesh(rough(), Matx22d(1.1, 0, 0, 1), Point2d()))), 1);
    EXPECT_GT(term.evaluate(stateOf(affineMesh(rough(), Matx22d(-1, 0, 0, 1), Point2d()))), 1);
}

TEST(Gcpw_SimilarityTerm, its_energy_is_that_of_equation_st1_over_two_triangles_a_quad)
{
    const MeshGrid before = rough();
    const MeshGrid after = deformed().meshes[0];
    double expected = 0;
    for (int cell = 0; cell < LATTICE.cellCount(); ++cell)
    {
        const auto corners = [&](const MeshGrid& mesh, int i, int j, int k, Point2d(&out)[3])
        {
            out[0] = mesh.vertex(cell, i);
            out[1] = mesh.vertex(cell, j);
            out[2] = mesh.vertex(cell, k);
        };
        Point2d p[3];
        Point2d q[3];
        corners(before, 0, 1, 2, p);
        corners(after, 0, 1, 2, q);
        expected += WEIGHT * triangleEnergy(p, q);
        corners(before, 3, 2, 1, p);
        corners(after, 3, 2, 1, q);
        expected += WEIGHT * triangleEnergy(p, q);
    }
    EXPECT_NEAR(SimilarityTerm(0, before, WEIGHT).evaluate(stateOf(after)), expected, 1e-9 * expected);
}

TEST(Gcpw_SimilarityTerm, energy_equals_the_sum_of_the_accumulated_blocks)
{
    expectEnergyIsSumOfRows(accumulateSimilarity(SimilarityTerm(0, rough(), WEIGHT)), deformed());
}

TEST(Gcpw_SimilarityTerm, jacobian_equals_finite_differences)
{
    const LinearizeTerm accumulate = accumulateSimilarity(SimilarityTerm(0, rough(), WEIGHT));
    expectExactlyQuadratic(accumulate, deformed(), 0, COLUMNS, 2.0, 1e-9);
    expectGradientIsSlope(accumulate, deformed(), 0, COLUMNS, 1e-3, 1e-7);
}

TEST(Gcpw_SimilarityTerm, with_a_stretch_limit_the_gradient_is_the_slope)
{
    const LinearizeTerm accumulate = accumulateSimilarity(SimilarityTerm(0, rough(), WEIGHT, 0.2));
    expectGradientIsSlope(accumulate, deformed(), 0, COLUMNS, 1e-4, 1e-6);
}

TEST(Gcpw_SimilarityTerm, at_the_stretch_limit_the_resistance_has_doubled)
{
    const MeshGrid square(Lattice(Size(60, 60), 3, 3));
    const double limit = 0.1;
    const auto slopeAt = [&](const SimilarityTerm& term, double stretch)
    {
        const auto energy = [&](double s)
        {
            return term.evaluate({{affineMesh(square, Matx22d(1 + s / 2, 0, 0, 1 - s / 2), Point2d()), ColorGrid(square.lattice())}});
        };
        return (energy(stretch + 1e-4) - energy(stretch - 1e-4)) / 2e-4;
    };
    const SimilarityTerm plain(0, square, WEIGHT);
    const SimilarityTerm limited(0, square, WEIGHT, limit);
    EXPECT_NEAR(slopeAt(limited, limit) / slopeAt(plain, limit), 2, 0.01);
    EXPECT_NEAR(slopeAt(limited, 0.01) / slopeAt(plain, 0.01), 1.01, 0.01);
    EXPECT_NEAR(slopeAt(limited, 0.3) / slopeAt(plain, 0.3), 10, 0.1);
}

TEST(Gcpw_SimilarityTerm, numbers_stay_good_far_from_the_origin)
{
    SimilarityTerm term(0, rough(), WEIGHT);
    const MeshGrid far = affineMesh(deformed().meshes[0], Matx22d::eye(), Point2d(1e7, -1e7));
    EXPECT_NEAR(term.evaluate(stateOf(far)), term.evaluate(stateOf(deformed().meshes[0])), 1e-4);
}

}} // namespace
