// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#include "test_precomp.hpp"

#include "bent_mesh.hpp"
#include "term_laws.hpp"
#include "energy/anchor_term.hpp"

namespace opencv_test { namespace {

using namespace cv::gcpw;

const Lattice LATTICE(Size(80, 60), 4, 3);
const double WEIGHT = 0.3;

MeshGrid anchorMesh()
{
    return bentMesh(LATTICE, 3, 1);
}

LinearizeTerm accumulateAnchors(const std::vector<int>& cells)
{
    return linearizing(std::make_shared<AnchorTerm>(0, anchorMesh(), cells, WEIGHT));
}

TermState displaced()
{
    return TermState({bentMesh(LATTICE, 4, 2)});
}

TEST(Gcpw_AnchorTerm, it_is_zero_at_the_anchor)
{
    const TermState truth({anchorMesh()});
    RecordingEquations equations({LATTICE});
    EXPECT_EQ(accumulateAnchors({2, 7})(truth, equations), 0);
    EXPECT_EQ(equations.gradient().norm(), 0);
    EXPECT_EQ(equations.blocks.size(), 2u);
}

TEST(Gcpw_AnchorTerm, its_energy_is_the_weighted_sum_of_squared_distances_of_the_corners)
{
    const TermState state = displaced();
    double expected = 0;
    for (const int cell : {2, 7})
        for (int k = 0; k < 4; ++k)
        {
            const Point2d r = state.meshes[0].vertex(cell, k) - anchorMesh().vertex(cell, k);
            expected += WEIGHT * r.dot(r);
        }
    RecordingEquations equations({LATTICE});
    EXPECT_NEAR(accumulateAnchors({2, 7})(state, equations), expected, 1e-12);
    expectEnergyIsSumOfRows(accumulateAnchors({2, 7}), state);
}

TEST(Gcpw_AnchorTerm, jacobian_equals_finite_differences)
{
    const int all = 2 * LATTICE.vertexCount();
    expectExactlyQuadratic(accumulateAnchors({2, 3, 7}), displaced(), 0, all, 2.0, 1e-9);
    expectGradientIsSlope(accumulateAnchors({2, 3, 7}), displaced(), 0, all, 1e-3, 1e-7);
}

TEST(Gcpw_AnchorTerm, without_quads_there_are_no_rows)
{
    RecordingEquations equations({LATTICE});
    EXPECT_EQ(accumulateAnchors({})(displaced(), equations), 0);
    EXPECT_TRUE(equations.empty());
}

}} // namespace
