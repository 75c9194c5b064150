// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#include "energy/point_term.hpp"

#include <cmath>
#include <limits>

namespace cv
{
namespace gcpw
{

PointTerm::PointTerm(int image_a, int image_b, const Lattice& lattice_a, const Lattice& lattice_b,
                     const std::vector<PointMatch>& matches, double weight, const RobustLoss& loss, Point2d shift_b)
    : image_a_(image_a), image_b_(image_b), loss_(loss), shift_b_(shift_b)
{
    pairs_.reserve(matches.size());
    for (const PointMatch& match : matches)
    {
        // A mesh is not defined outside its image: such a match keeps its place in the order, with no cell.
        // So does one whose weight is negative or not finite.
        const bool inside = lattice_a.contains(match.a) && lattice_b.contains(match.b) && match.weight >= 0 &&
                            std::isfinite(match.weight);
        pairs_.push_back({inside ? lattice_a.locate(match.a) : CellPoint(), inside ? lattice_b.locate(match.b) : CellPoint(),
                          weight * match.weight});
    }
}

Point2d PointTerm::residual(const Pair& pair, const State& state) const
{
    return state[image_a_].mesh.warp(pair.a) - state[image_b_].mesh.warp(pair.b) - shift_b_;
}

double PointTerm::evaluate(const State& state) const
{
    double energy = 0;
    for (const Pair& pair : pairs_)
    {
        if (pair.a.cell < 0)
            continue;
        const Point2d r = residual(pair, state);
        energy += pair.weight * loss_.value(r.dot(r));
    }
    return energy;
}

double PointTerm::linearize(const State& state, NormalEquations& equations)
{
    double energy = 0;
    for (const Pair& pair : pairs_)
    {
        if (pair.a.cell < 0)
            continue;
        const Point2d r = residual(pair, state);
        const double squared = r.dot(r);
        energy += pair.weight * loss_.value(squared);
        const double weight = pair.weight * loss_.weight(squared);
        for (int axis = 0; axis < 2; ++axis)
        {
            QuadRow row_a{};
            QuadRow row_b{};
            for (int k = 0; k < 4; ++k)
            {
                row_a[2 * k + axis] = pair.a.weight[k];
                row_b[2 * k + axis] = -pair.b.weight[k];
            }
            equations.addRow({image_a_, pair.a.cell}, row_a, {image_b_, pair.b.cell}, row_b, axis == 0 ? r.x : r.y, weight);
        }
    }
    return energy;
}

std::vector<double> PointTerm::distances(const State& state) const
{
    std::vector<double> result;
    result.reserve(pairs_.size());
    for (const Pair& pair : pairs_)
        result.push_back(pair.a.cell < 0 ? std::numeric_limits<double>::infinity() : norm(residual(pair, state)));
    return result;
}

} // namespace gcpw
} // namespace cv
