// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#include "energy/anchor_term.hpp"

namespace cv
{
namespace gcpw
{

AnchorTerm::AnchorTerm(int image, const MeshGrid& anchor, const std::vector<int>& cells, double weight, const char* name)
    : image_(image), anchor_(anchor), cells_(cells), weight_(weight), name_(name)
{
}

double AnchorTerm::evaluate(const State& state) const
{
    double energy = 0;
    for (int cell : cells_)
        for (int k = 0; k < 4; ++k)
        {
            const Point2d r = state[image_].mesh.vertex(cell, k) - anchor_.vertex(cell, k);
            energy += weight_ * r.dot(r);
        }
    return energy;
}

double AnchorTerm::linearize(const State& state, NormalEquations& equations)
{
    double energy = 0;
    for (int cell : cells_)
    {
        QuadBlock block{};
        QuadRow gradient{};
        double sum = 0;
        for (int k = 0; k < 4; ++k)
        {
            const Point2d r = state[image_].mesh.vertex(cell, k) - anchor_.vertex(cell, k);
            block[2 * k][2 * k] = block[2 * k + 1][2 * k + 1] = weight_;
            gradient[2 * k] = weight_ * r.x;
            gradient[2 * k + 1] = weight_ * r.y;
            sum += weight_ * r.dot(r);
        }
        equations.addBlock({image_, cell}, block, gradient, sum);
        energy += sum;
    }
    return energy;
}

} // namespace gcpw
} // namespace cv
