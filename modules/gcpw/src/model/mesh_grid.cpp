// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#include "model/mesh_grid.hpp"

#include <algorithm>
#include <cmath>

namespace cv
{
namespace gcpw
{

namespace
{

std::array<Point2d, 4> quadOf(const MeshGrid& mesh, int cell)
{
    return {{mesh.vertex(cell, 0), mesh.vertex(cell, 1), mesh.vertex(cell, 2), mesh.vertex(cell, 3)}};
}

/// Whether a point is in the bounding box of a quad.
bool mayFix(const std::array<Point2d, 4>& quad, Point2d p)
{
    const auto x = std::minmax({quad[0].x, quad[1].x, quad[2].x, quad[3].x});
    const auto y = std::minmax({quad[0].y, quad[1].y, quad[2].y, quad[3].y});
    const double margin = 1e-6; // px; the exact test follows
    return p.x >= x.first - margin && p.x <= x.second + margin && p.y >= y.first - margin && p.y <= y.second + margin;
}

/// Fractions of a point by the tangent of a quad at its centre: in which direction the point lies, however far away.
Point2d affineFractions(const std::array<Point2d, 4>& quad, Point2d p)
{
    const Point2d along_u = 0.5 * (quad[1] - quad[0] + quad[3] - quad[2]);
    const Point2d along_v = 0.5 * (quad[2] - quad[0] + quad[3] - quad[1]);
    const Point2d offset = p - 0.25 * (quad[0] + quad[1] + quad[2] + quad[3]);
    const double det = along_u.cross(along_v);
    return {0.5 + offset.cross(along_v) / det, 0.5 + along_u.cross(offset) / det};
}

/// The column (or row) `fraction` cells further, at most `reach` and never off the lattice.
int moveCell(int index, double fraction, double reach, int count)
{
    const int move = static_cast<int>(std::min(std::max(std::floor(fraction), -reach), reach));
    return std::min(std::max(index + move, 0), count - 1);
}

} // namespace

MeshGrid::MeshGrid(const Lattice& lattice, Point2d origin) : lattice_(lattice), vertices_(lattice.vertexCount())
{
    for (int i = 0; i < lattice.vertexCount(); ++i)
        vertices_[i] = lattice.referenceVertex(i) + origin;
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
    // Walk: each quad says in which direction the point lies. Far extrapolations of one quad are wild: move at most a
    // quarter of the lattice at a time. Twice round the lattice is ample.
    const Point2d reach = Point(cols / 4 + 1, rows / 4 + 1);
    const int max_steps = 2 * (cols + rows);
    int step = 0;
    for (; step < max_steps; ++step)
    {
        Point2d fractions;
        if (findIn(hint, canvas_px, point, fractions))
            return true;
        if (!(std::abs(fractions.x) < 1e9) || !(std::abs(fractions.y) < 1e9))
            return false; // no such place, or a quad without area
        const int col = moveCell(hint % cols, fractions.x, reach.x, cols);
        const int row = moveCell(hint / cols, fractions.y, reach.y, rows);
        const int next = row * cols + col;
        if (next == hint)
            break;
        hint = next;
    }
    // A bent mesh may lead the walk to the border beside the point, or round in circles: search the quads around its end.
    const int ring = step < max_steps ? 2 : std::max(cols, rows);
    const int centre = hint;
    for (int row = std::max(centre / cols - ring, 0); row <= std::min(centre / cols + ring, rows - 1); ++row)
        for (int col = std::max(centre % cols - ring, 0); col <= std::min(centre % cols + ring, cols - 1); ++col)
        {
            hint = row * cols + col;
            Point2d fractions;
            if (mayFix(quadOf(*this, hint), canvas_px) && findIn(hint, canvas_px, point, fractions))
                return true;
        }
    hint = centre;
    return false;
}

bool MeshGrid::findIn(int cell, Point2d canvas_px, CellPoint& point, Point2d& fractions) const
{
    const auto quad = quadOf(*this, cell);
    if (!invertBilinear(quad, canvas_px, fractions.x, fractions.y))
    {
        fractions = affineFractions(quad, canvas_px);
        return false;
    }
    if (!isInQuad(fractions.x, fractions.y))
        return false;
    point.cell = cell;
    point.weight = bilinearWeights(std::min(std::max(fractions.x, 0.0), 1.0), std::min(std::max(fractions.y, 0.0), 1.0));
    return true;
}

double MeshGrid::cornerArea(int cell, int corner) const
{
    return gcpw::cornerArea(quadOf(*this, cell), corner);
}

bool MeshGrid::isTranslation(Point2d& origin) const
{
    origin = vertices_[0] - lattice_.referenceVertex(0);
    for (int i = 1; i < lattice_.vertexCount(); ++i)
        if (vertices_[i] != lattice_.referenceVertex(i) + origin)
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
    // point = a + u b + v c + u v d. Crossing point - a - v c with b + v d removes u and leaves
    // f(v) = p v^2 + q v + r = 0, whose slope at a root is the Jacobian's determinant there. The quad lies on the sheet
    // where that has the sign it has at the centre: of two roots only one is meant.
    const Point2d b = quad[1] - quad[0];
    const Point2d c = quad[2] - quad[0];
    const Point2d d = quad[3] - quad[1] - c;
    const Point2d e = point - quad[0];
    const double det = (b + 0.5 * d).cross(c + 0.5 * d);
    if (!(std::abs(det) > 1e-12))
        return false;
    const double sheet = det > 0 ? 1 : -1;
    const double p = -sheet * c.cross(d);
    const double q = sheet * (e.cross(d) - c.cross(b));
    const double r = sheet * e.cross(b);
    const double discriminant = q * q - 4 * p * r;
    if (!(discriminant >= 0))
        return false;
    const double root = std::sqrt(discriminant);
    v = q > 0 ? -2 * r / (q + root) : (root - q) / (2 * p); // the form without cancellation
    const Point2d along = b + v * d;
    u = (e - v * c).dot(along) / along.dot(along);
    return std::isfinite(u) && std::isfinite(v);
}

bool isInQuad(double u, double v)
{
    return std::abs(u - 0.5) <= 0.5 + BORDER_FRACTION && std::abs(v - 0.5) <= 0.5 + BORDER_FRACTION;
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

MeshGrid moved(const MeshGrid& mesh, const std::vector<Point2d>& step)
{
    CV_DbgAssert(step.size() == mesh.vertices().size());
    MeshGrid next = mesh;
    for (size_t i = 0; i < step.size(); ++i)
        next.vertices()[i] += step[i];
    return next;
}

} // namespace gcpw
} // namespace cv
