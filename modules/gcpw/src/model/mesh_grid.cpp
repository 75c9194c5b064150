// Part of the GCPW module for OpenCV. Licence: Apache-2.0 (see LICENSE).
#include "model/mesh_grid.hpp"

#include <algorithm>
#include <cmath>

namespace cv
{
namespace gcpw
{

namespace
{

/// How far outside [0, 1] a fraction still counts as on the border of its quad.
const double BORDER_FRACTION = 1e-9;

std::array<Point2d, 4> quadOf(const MeshGrid& mesh, int cell)
{
    return {{mesh.vertex(cell, 0), mesh.vertex(cell, 1), mesh.vertex(cell, 2), mesh.vertex(cell, 3)}};
}

} // namespace

MeshGrid::MeshGrid(const Lattice& lattice, Point2d origin) : lattice_(lattice), vertices_(lattice.vertexCount())
{
    for (int i = 0; i < lattice.vertexCount(); ++i)
        vertices_[i] = lattice.restVertex(i) + origin;
}

Point2d MeshGrid::warp(const CellPoint& point) const
{
    Point2d canvas;
    for (int k = 0; k < 4; ++k)
        canvas += point.weight[k] * vertex(point.cell, k);
    return canvas;
}

Matx22d MeshGrid::jacobian(const CellPoint& point) const
{
    const double u = point.weight[1] + point.weight[3];
    const double v = point.weight[2] + point.weight[3];
    const auto quad = quadOf(*this, point.cell);
    const Point2d du = ((1 - v) * (quad[1] - quad[0]) + v * (quad[3] - quad[2])) / lattice_.cellSize().width;
    const Point2d dv = ((1 - u) * (quad[2] - quad[0]) + u * (quad[3] - quad[1])) / lattice_.cellSize().height;
    return {du.x, dv.x, du.y, dv.y};
}

bool MeshGrid::invert(Point2d canvas_px, int& hint, CellPoint& point) const
{
    const int cols = lattice_.cols();
    const int rows = lattice_.rows();
    if (hint < 0 || hint >= lattice_.cellCount())
        hint = (rows / 2) * cols + cols / 2;
    int col = hint % cols;
    int row = hint / cols;
    // Walk: each quad says in which direction the point lies. Twice round the lattice is ample in a mesh without folds.
    for (int step = 0; step < 2 * (cols + rows); ++step)
    {
        const int cell = row * cols + col;
        double u = 0;
        double v = 0;
        if (!invertBilinear(quadOf(*this, cell), canvas_px, u, v))
            return false;
        hint = cell;
        const bool inside = u >= -BORDER_FRACTION && v >= -BORDER_FRACTION && u <= 1 + BORDER_FRACTION &&
                            v <= 1 + BORDER_FRACTION;
        if (inside)
        {
            point.cell = cell;
            point.weight = bilinearWeights(std::min(std::max(u, 0.0), 1.0), std::min(std::max(v, 0.0), 1.0));
            return true;
        }
        const int next_col = std::min(std::max(col + static_cast<int>(std::floor(u)), 0), cols - 1);
        const int next_row = std::min(std::max(row + static_cast<int>(std::floor(v)), 0), rows - 1);
        if (next_col == col && next_row == row)
            return false;
        // Far extrapolations of one quad are wild: move at most a quarter of the lattice at a time.
        col += std::min(std::max(next_col - col, -cols / 4 - 1), cols / 4 + 1);
        row += std::min(std::max(next_row - row, -rows / 4 - 1), rows / 4 + 1);
    }
    return false;
}

double MeshGrid::cornerArea(int cell, int corner) const
{
    return gcpw::cornerArea(quadOf(*this, cell), corner);
}

bool MeshGrid::isTranslation(Point2d& origin) const
{
    origin = vertices_[0] - lattice_.restVertex(0);
    for (int i = 1; i < lattice_.vertexCount(); ++i)
        if (vertices_[i] != lattice_.restVertex(i) + origin)
            return false;
    return true;
}

int MeshGrid::countFolds() const
{
    int folds = 0;
    for (int cell = 0; cell < lattice_.cellCount(); ++cell)
    {
        bool upright = true;
        for (int k = 0; k < 4; ++k)
            upright = upright && cornerArea(cell, k) > 0; // also false for NaN
        folds += upright ? 0 : 1;
    }
    return folds;
}

Rect2d MeshGrid::bounds() const
{
    Point2d low = vertices_.front();
    Point2d high = low;
    for (const Point2d& v : vertices_)
    {
        low = Point2d(std::min(low.x, v.x), std::min(low.y, v.y));
        high = Point2d(std::max(high.x, v.x), std::max(high.y, v.y));
    }
    return {low, high};
}

double cornerArea(const std::array<Point2d, 4>& quad, int corner)
{
    const int along_row = corner ^ 1;
    const int along_col = corner ^ 2;
    const double area = (quad[along_row] - quad[corner]).cross(quad[along_col] - quad[corner]);
    return corner == 0 || corner == 3 ? area : -area;
}

bool invertBilinear(const std::array<Point2d, 4>& quad, Point2d point, double& u, double& v)
{
    // point = a + u b + v c + u v d
    const Point2d a = quad[0];
    const Point2d b = quad[1] - quad[0];
    const Point2d c = quad[2] - quad[0];
    const Point2d d = quad[3] - quad[1] - c;
    u = v = 0.5;
    for (int i = 0; i < 20; ++i)
    {
        const Point2d r = a + u * b + v * c + (u * v) * d - point;
        const Point2d ju = b + v * d;
        const Point2d jv = c + u * d;
        const double det = ju.cross(jv);
        if (!(std::abs(det) > 1e-12))
            return false;
        const double step_u = r.cross(jv) / det;
        const double step_v = ju.cross(r) / det;
        u -= step_u;
        v -= step_v;
        if (std::abs(step_u) + std::abs(step_v) < 1e-12)
            break;
    }
    return std::isfinite(u) && std::isfinite(v);
}

double maxVertexDistance(const MeshGrid& a, const MeshGrid& b)
{
    CV_DbgAssert(a.vertices().size() == b.vertices().size());
    double squared = 0;
    for (size_t i = 0; i < a.vertices().size(); ++i)
    {
        const Point2d d = a.vertices()[i] - b.vertices()[i];
        squared = std::max(squared, d.dot(d));
    }
    return std::sqrt(squared);
}

} // namespace gcpw
} // namespace cv
