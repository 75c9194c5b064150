// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#include "energy/outside_term.hpp"

namespace cv
{
namespace gcpw
{

namespace
{

const int EDGES[4][2] = {{0, 1}, {2, 3}, {0, 2}, {1, 3}}; ///< of a quad, by its corners

} // namespace

OutsideTerm::OutsideTerm(int image, const MeshGrid& rough, const std::vector<double>& cell_weights, double weight)
    : image_(image), rough_(rough)
{
    CV_Assert(static_cast<int>(cell_weights.size()) == rough.lattice().cellCount());
    for (const double w : cell_weights)
        weights_.push_back(weight * w);
}

double OutsideTerm::add(const State& state, NormalEquations* equations) const
{
    double total = 0;
    for (int cell = 0; cell < rough_.lattice().cellCount(); ++cell)
    {
        const double w = weights_[cell];
        if (w == 0)
            continue;
        QuadBlock block{};
        QuadRow gradient{};
        double energy = 0;
        for (const auto& edge : EDGES)
        {
            const int i = edge[0];
            const int j = edge[1];
            const MeshGrid& mesh = state[image_].mesh;
            const Point2d change = (mesh.vertex(cell, i) - rough_.vertex(cell, i)) - (mesh.vertex(cell, j) - rough_.vertex(cell, j));
            energy += w * change.dot(change);
            for (int axis = 0; axis < 2; ++axis)
            {
                const double c = w * (axis == 0 ? change.x : change.y);
                gradient[2 * i + axis] += c;
                gradient[2 * j + axis] -= c;
                block[2 * i + axis][2 * i + axis] += w;
                block[2 * j + axis][2 * j + axis] += w;
                block[2 * i + axis][2 * j + axis] -= w;
                block[2 * j + axis][2 * i + axis] -= w;
            }
        }
        if (equations)
            equations->addBlock({image_, cell}, block, gradient, energy);
        total += energy;
    }
    return total;
}

double OutsideTerm::evaluate(const State& state) const
{
    return add(state, nullptr);
}

double OutsideTerm::linearize(const State& state, NormalEquations& equations)
{
    return add(state, &equations);
}

} // namespace gcpw
} // namespace cv
