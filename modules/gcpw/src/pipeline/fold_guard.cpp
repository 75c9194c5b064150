// Part of the GCPW module for OpenCV. Licence: Apache-2.0 (see LICENSE).
#include "pipeline/fold_guard.hpp"

#include <algorithm>

namespace cv
{
namespace gcpw
{

namespace
{

const int PATIENCE = 8;    ///< halvings of a vertex before it is stopped
const int MAX_ROUNDS = 40; ///< then nothing moves

} // namespace

FoldGuard::FoldGuard(const MeshGrid& rough, double min_share)
{
    for (int cell = 0; cell < rough.lattice().cellCount(); ++cell)
        for (int k = 0; k < 4; ++k)
            bound_.push_back(min_share * rough.cornerArea(cell, k));
}

std::vector<int> FoldGuard::violated(const MeshGrid& mesh, const std::vector<Point2d>& step, double share) const
{
    const MeshGrid next = moved(mesh, step, share);
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

void FoldGuard::shorten(const MeshGrid& mesh, std::vector<Point2d>& step) const
{
    for (int round = 0; round < MAX_ROUNDS; ++round)
    {
        const std::vector<int> cells = violated(mesh, step);
        if (cells.empty())
            return;
        std::vector<bool> halve(step.size(), false);
        for (int cell : cells)
            for (int k = 0; k < 4; ++k)
                halve[mesh.lattice().vertexOf(cell, k)] = true;
        const double factor = round < PATIENCE ? 0.5 : 0;
        for (size_t i = 0; i < step.size(); ++i)
            if (halve[i])
                step[i] *= factor;
    }
    std::fill(step.begin(), step.end(), Point2d());
}

MeshGrid moved(const MeshGrid& mesh, const std::vector<Point2d>& step, double share)
{
    CV_DbgAssert(step.size() == mesh.vertices().size());
    MeshGrid next = mesh;
    for (size_t i = 0; i < step.size(); ++i)
        next.vertices()[i] += share * step[i];
    return next;
}

} // namespace gcpw
} // namespace cv
