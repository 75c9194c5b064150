// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#include "energy/outside_term.hpp"

#include "energy/quad_form.hpp"

namespace cv
{
namespace gcpw
{

namespace
{

const int EDGES[4][2] = {{0, 1}, {2, 3}, {0, 2}, {1, 3}}; ///< of a quad, by its corners

/// weight * sum over the edges (i, j) of | x_i - x_j |^2
QuadBlock edgeBlock(double weight)
{
    QuadBlock block{};
    for (const auto& edge : EDGES)
        for (int axis = 0; axis < 2; ++axis)
        {
            const int i = 2 * edge[0] + axis;
            const int j = 2 * edge[1] + axis;
            block[i][i] += weight;
            block[j][j] += weight;
            block[i][j] -= weight;
            block[j][i] -= weight;
        }
    return block;
}

} // namespace

OutsideTerm::OutsideTerm(int image, const MeshGrid& rough, const std::vector<double>& cell_weights, double weight)
    : image_(image), rough_(rough)
{
    CV_Assert(static_cast<int>(cell_weights.size()) == rough.lattice().cellCount());
    for (size_t cell = 0; cell < cell_weights.size(); ++cell)
        if (weight * cell_weights[cell] > 0)
            quads_.push_back({static_cast<int>(cell), edgeBlock(weight * cell_weights[cell])});
}

double OutsideTerm::slope(const Quad& quad, const State& state, QuadRow& gradient) const
{
    QuadPoints moves;
    for (int k = 0; k < 4; ++k)
        moves[k] = state[image_].mesh.vertex(quad.cell, k) - rough_.vertex(quad.cell, k);
    return quadForm(quad.block, moves, gradient);
}

double OutsideTerm::evaluate(const State& state) const
{
    double total = 0;
    QuadRow ignored;
    for (const Quad& quad : quads_)
        total += slope(quad, state, ignored);
    return total;
}

double OutsideTerm::linearize(const State& state, NormalEquations& equations)
{
    double total = 0;
    for (const Quad& quad : quads_)
    {
        QuadRow gradient;
        const double energy = slope(quad, state, gradient);
        equations.addBlock({image_, quad.cell}, quad.block, gradient, energy);
        total += energy;
    }
    return total;
}

} // namespace gcpw
} // namespace cv
