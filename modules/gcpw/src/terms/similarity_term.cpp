// Part of the GCPW module for OpenCV. Licence: Apache-2.0 (see LICENSE).
#include "terms/similarity_term.hpp"

#include <algorithm>

namespace cv
{
namespace gcpw
{

namespace
{

const double MAX_FACTOR = 1e4; ///< a quad this stiff moves as one piece; more would spoil the conditioning

/// Adds the two rows of one triangle; `corners` are the quad corners taken as v1, v2, v3.
void addTriangle(const MeshGrid& rough, int cell, const int (&corners)[3], double weight, QuadBlock& block)
{
    const Point2d v1 = rough.vertex(cell, corners[0]);
    const Point2d v2 = rough.vertex(cell, corners[1]);
    const Point2d edge = rough.vertex(cell, corners[2]) - v2;
    const double length = edge.dot(edge);
    const Point2d turned(edge.y, -edge.x); // R90 edge with R90 = [0 1; -1 0]
    const double u = (v1 - v2).dot(edge) / length;
    const double v = (v1 - v2).dot(turned) / length;
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
            block[i][j] += weight * (x[i] * x[j] + y[i] * y[j]);
}

QuadBlock scaled(QuadBlock block, double factor)
{
    for (auto& row : block)
        for (double& value : row)
            value *= factor;
    return block;
}

} // namespace

SimilarityTerm::SimilarityTerm(int image, const MeshGrid& rough, double weight)
    : image_(image), quads_(rough.lattice().cellCount())
{
    for (int cell = 0; cell < rough.lattice().cellCount(); ++cell)
    {
        quads_[cell].block = QuadBlock{};
        addTriangle(rough, cell, {0, 1, 2}, weight, quads_[cell].block);
        addTriangle(rough, cell, {3, 2, 1}, weight, quads_[cell].block);
    }
}

double SimilarityTerm::slope(int cell, const MeshGrid& mesh, QuadRow& gradient) const
{
    QuadRow x{};
    // The block ignores a shift of the whole quad: taking corner 0 as origin keeps the numbers small.
    const Point2d origin = mesh.vertex(cell, 0);
    for (int k = 0; k < 4; ++k)
    {
        const Point2d v = mesh.vertex(cell, k) - origin;
        x[2 * k] = v.x;
        x[2 * k + 1] = v.y;
    }
    gradient = QuadRow{};
    double energy = 0;
    for (int i = 0; i < 8; ++i)
    {
        for (int j = 0; j < 8; ++j)
            gradient[i] += quads_[cell].block[i][j] * x[j];
        energy += gradient[i] * x[i];
    }
    return energy;
}

double SimilarityTerm::linearize(const MeshGrid& mesh, ResidualSink& sink) const
{
    double total = 0;
    for (int cell = 0; cell < static_cast<int>(quads_.size()); ++cell)
    {
        QuadRow gradient;
        const double energy = slope(cell, mesh, gradient);
        sink.addBlock({image_, cell}, scaled(quads_[cell].block, quads_[cell].factor), gradient, energy);
        total += energy;
    }
    return total;
}

double SimilarityTerm::energy(const MeshGrid& mesh) const
{
    double total = 0;
    QuadRow ignored;
    for (int cell = 0; cell < static_cast<int>(quads_.size()); ++cell)
        total += slope(cell, mesh, ignored);
    return total;
}

void SimilarityTerm::relax()
{
    for (Stiff& quad : quads_)
        quad.factor = 1;
}

void SimilarityTerm::stiffen(int cell, double factor, ResidualSink& sink)
{
    const double next = std::min(quads_[cell].factor * factor, MAX_FACTOR);
    sink.addBlock({image_, cell}, scaled(quads_[cell].block, next - quads_[cell].factor), QuadRow{}, 0);
    quads_[cell].factor = next;
}

} // namespace gcpw
} // namespace cv
