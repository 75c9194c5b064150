// Part of the GCPW module for OpenCV. Licence: Apache-2.0 (see LICENSE).
#include "pipeline/fold_guard.hpp"

namespace cv
{
namespace gcpw
{

FoldGuard::FoldGuard(const MeshGrid& rough, double min_share)
{
    for (int cell = 0; cell < rough.lattice().cellCount(); ++cell)
        for (int k = 0; k < 4; ++k)
            bound_.push_back(min_share * rough.cornerArea(cell, k));
}

std::vector<int> FoldGuard::violated(const MeshGrid& mesh, const std::vector<Point2d>& step) const
{
    const MeshGrid next = moved(mesh, step, 1);
    std::vector<int> cells;
    for (int cell = 0; cell < mesh.lattice().cellCount(); ++cell)
    {
        bool good = true;
        for (int k = 0; k < 4; ++k)
            good = good && next.cornerArea(cell, k) >= bound_[4 * cell + k]; // false for NaN
        if (!good)
            cells.push_back(cell);
    }
    return cells;
}

double FoldGuard::allowed(const MeshGrid& mesh, const std::vector<Point2d>& step) const
{
    std::vector<Point2d> part = step;
    for (double share = 1; share > 1e-3; share *= 0.5)
    {
        if (violated(mesh, part).empty())
            return share;
        for (Point2d& p : part)
            p *= 0.5;
    }
    return 0;
}

MeshGrid moved(const MeshGrid& mesh, const std::vector<Point2d>& step, double share)
{
    MeshGrid next = mesh;
    for (size_t i = 0; i < step.size(); ++i)
        next.vertices()[i] += share * step[i];
    return next;
}

} // namespace gcpw
} // namespace cv
