// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#include "test_precomp.hpp"

#include "energy/similarity_term.hpp"
#include "optimization/gauss_newton.hpp"
#include "term_laws.hpp"

// A term that the module does not know: all that a new energy needs stands in this file.
namespace opencv_test { namespace {

using namespace cv::gcpw;

/** @brief Draws the corners of an image's mesh to chosen places.

    E = weight * sum_k | V_corner(k) - P_k |^2
*/
class CornerTerm : public EnergyTerm
{
public:
    CornerTerm(int image, const std::array<Point2d, 4>& places, double weight) : image_(image), places_(places), weight_(weight) {}

    const char* name() const override { return "corners"; }

    double evaluate(const State& state) const override
    {
        double energy = 0;
        for (int k = 0; k < 4; ++k)
        {
            const Point2d r = residual(state, k);
            energy += weight_ * r.dot(r);
        }
        return energy;
    }

    double linearize(const State& state, NormalEquations& equations) override
    {
        for (int k = 0; k < 4; ++k)
        {
            const Point2d r = residual(state, k);
            for (int axis = 0; axis < 2; ++axis)
            {
                QuadRow row{};
                row[2 * k + axis] = 1;
                equations.addRow({image_, cellOf(state, k)}, row, axis == 0 ? r.x : r.y, weight_);
            }
        }
        return evaluate(state);
    }

private:
    /// The quad whose corner k is corner k of the mesh.
    int cellOf(const State& state, int k) const
    {
        const Lattice& lattice = state[image_].mesh.lattice();
        return (k & 1 ? lattice.cols() - 1 : 0) + (k >> 1 ? (lattice.rows() - 1) * lattice.cols() : 0);
    }
    Point2d residual(const State& state, int k) const { return state[image_].mesh.vertex(cellOf(state, k), k) - places_[k]; }

    int image_;
    std::array<Point2d, 4> places_;
    double weight_;
};

const Lattice LATTICE(Size(80, 60), 4, 3);

std::array<Point2d, 4> placesBeside(Point2d shift)
{
    const MeshGrid mesh(LATTICE);
    return {{mesh.vertex(0, 0) + shift, mesh.vertex(3, 1) + shift, mesh.vertex(8, 2) + shift, mesh.vertex(11, 3) + shift}};
}

TEST(Gcpw_ToyTerm, it_keeps_the_laws_of_all_terms)
{
    const TermState state({MeshGrid(LATTICE)});
    const auto term = std::make_shared<CornerTerm>(0, placesBeside(Point2d(3, -2)), 0.7);
    expectEnergyIsSumOfRows(linearizing(term), state);
    expectExactlyQuadratic(linearizing(term), state, 0, 2 * LATTICE.vertexCount(), 1, 1e-9);
    EXPECT_NEAR(term->evaluate(state.state()), 0.7 * 4 * 13, 1e-9);
}

TEST(Gcpw_ToyTerm, the_optimiser_minimises_and_reports_a_term_it_has_never_seen)
{
    Problem problem;
    problem.images.resize(1);
    problem.images[0].rough = MeshGrid(LATTICE);
    State state{{problem.images[0].rough, ColorGrid(LATTICE)}};
    const Point2d shift(5, -3);
    Energy energy;
    energy.add(std::make_unique<CornerTerm>(0, placesBeside(shift), 1));
    energy.add(std::make_unique<SimilarityTerm>(0, problem.images[0].rough, 1));
    GaussNewton solver(problem, Params(), false);
    GaussNewton::Rules rules;
    rules.max_iterations = 20;
    rules.stop_motion_px = 1e-6;
    LevelReport report;
    ASSERT_EQ(solver.run(energy, state, rules, report), GaussNewton::End::Done);
    EXPECT_EQ(report.stop, StopReason::MESH_STABLE);
    for (int vertex = 0; vertex < LATTICE.vertexCount(); ++vertex)
        EXPECT_LT(cv::norm(state[0].mesh.vertices()[vertex] - LATTICE.referenceVertex(vertex) - shift), 1e-3) << vertex;
    ASSERT_EQ(report.start.size(), size_t(2));
    EXPECT_EQ(report.start[0].name, "corners");
    EXPECT_NEAR(report.start[0].value, 4 * 34, 1e-9);
    EXPECT_NEAR(report.end[0].value, 0, 1e-6);
}

}} // namespace
