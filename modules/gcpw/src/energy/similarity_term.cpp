// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#include "energy/similarity_term.hpp"

#include "energy/quad_form.hpp"

namespace cv
{
namespace gcpw
{

namespace
{

/// Adds the two rows of one triangle; `corners` are the quad corners taken as v1, v2, v3.
void addTriangle(const MeshGrid& rough, int cell, const int (&corners)[3], QuadBlock& block)
{
    const Point2d v1 = rough.vertex(cell, corners[0]);
    const Point2d v2 = rough.vertex(cell, corners[1]);
    const Point2d edge = rough.vertex(cell, corners[2]) - v2;
    const double length = edge.dot(edge);
    const Point2d rotated(edge.y, -edge.x); // R90 edge with R90 = [0 1; -1 0]
    const double u = (v1 - v2).dot(edge) / length;
    const double v = (v1 - v2).dot(rotated) / length;
    // x: V1x - (1 - u) V2x - u V3x - v (V3y - V2y);   y: V1y - (1 - u) V2y - u V3y + v (V3x - V2x)
    QuadRow x{};
    QuadRow y{};
    x[2 * corners[0]] = y[2 * corners[0] + 1] = 1;
    x[2 * corners[1]] = y[2 * corners[1] + 1] = -(1 - u);
    x[2 * corners[2]] = y[2 * corners[2] + 1] = -u;
    x[2 * corners[1] + 1] = v;
    x[2 * corners[2] + 1] = -v;
    y[2 * corners[1]] = -v;
    y[2 * corners[2]] = v;
    for (int i = 0; i < 8; ++i)
        for (int j = 0; j < 8; ++j)
            block[i][j] += x[i] * x[j] + y[i] * y[j];
}

/// Energy of a quad at a mesh, and half its slope.
double slope(const QuadBlock& block, const MeshGrid& mesh, int cell, QuadRow& gradient)
{
    return quadForm(block, {{mesh.vertex(cell, 0), mesh.vertex(cell, 1), mesh.vertex(cell, 2), mesh.vertex(cell, 3)}},
                    gradient);
}

} // namespace

QuadBlock similarityBlock(const MeshGrid& rough, int cell)
{
    QuadBlock block{};
    addTriangle(rough, cell, {0, 1, 2}, block);
    addTriangle(rough, cell, {3, 2, 1}, block);
    return block;
}

SimilarityTerm::SimilarityTerm(int image, const MeshGrid& rough, double weight, double stretch_limit) : image_(image)
{
    const int count = rough.lattice().cellCount();
    for (int cell = 0; cell < count; ++cell)
    {
        blocks_.push_back(similarityBlock(rough, cell));
        for (auto& row : blocks_.back())
            for (double& value : row)
                value *= weight;
        const double area = 0.5 * (rough.cornerArea(cell, 0) + rough.cornerArea(cell, 3));
        const double unit = weight * area * stretch_limit * stretch_limit;
        growth_.push_back(unit > 0 ? 1 / unit : 0);
    }
}

double SimilarityTerm::evaluate(const State& state) const
{
    double total = 0;
    QuadRow ignored;
    for (size_t cell = 0; cell < blocks_.size(); ++cell)
    {
        const double energy = slope(blocks_[cell], state[image_].mesh, static_cast<int>(cell), ignored);
        total += energy * (1 + 0.5 * growth_[cell] * energy);
    }
    return total;
}

double SimilarityTerm::linearize(const State& state, NormalEquations& equations)
{
    double total = 0;
    for (size_t k = 0; k < blocks_.size(); ++k)
    {
        const int cell = static_cast<int>(k);
        QuadRow gradient;
        const double energy = slope(blocks_[k], state[image_].mesh, cell, gradient);
        // Of e (1 + c e / 2): the slope grows by 1 + c e, and the curvature by that and the square of the slope.
        const double growth = growth_[k];
        const double factor = 1 + growth * energy;
        QuadBlock block = blocks_[k];
        for (int i = 0; i < 8; ++i)
            for (int j = 0; j < 8; ++j)
                block[i][j] = factor * block[i][j] + 2 * growth * gradient[i] * gradient[j];
        for (double& value : gradient)
            value *= factor;
        const double value = energy * (1 + 0.5 * growth * energy);
        equations.addBlock({image_, cell}, block, gradient, value);
        total += value;
    }
    return total;
}

} // namespace gcpw
} // namespace cv
