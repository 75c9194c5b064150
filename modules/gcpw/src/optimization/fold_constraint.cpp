// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#include "optimization/fold_constraint.hpp"

#include <algorithm>
#include "energy/similarity_term.hpp"

namespace cv
{
namespace gcpw
{

namespace
{

const int PATIENCE = 8;    ///< halvings of a vertex before it is stopped
const int MAX_ROUNDS = 40; ///< then nothing moves
const double STIFFEN =
    12; ///< factor on the damping of a quad that a step would still fold: a few of them outweigh any term
const double MAX_FACTOR = 1e5; ///< a quad this stiff moves as one piece; more would spoil the conditioning

} // namespace

FoldConstraint::FoldConstraint(const MeshGrid& rough, double min_ratio, int image, double damping_weight)
    : rough_(rough), image_(image), damping_weight_(damping_weight), factor_(rough.lattice().cellCount(), 1)
{
    for (int cell = 0; cell < rough.lattice().cellCount(); ++cell)
        for (int k = 0; k < 4; ++k)
            bound_.push_back(min_ratio * rough.cornerArea(cell, k));
}

std::vector<int> FoldConstraint::violated(const MeshGrid& mesh, const std::vector<Point2d>& step) const
{
    const MeshGrid next = moved(mesh, step);
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

void FoldConstraint::shorten(const MeshGrid& mesh, std::vector<Point2d>& step) const
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

void FoldConstraint::relax()
{
    std::fill(factor_.begin(), factor_.end(), 1);
}

void FoldConstraint::addDamping(int cell, double factor, MeshEquations& equations) const
{
    QuadBlock block = similarityBlock(rough_, cell);
    for (auto& row : block)
        for (double& value : row)
            value *= damping_weight_ * factor;
    equations.addBlock({image_, cell}, block, QuadRow{}, 0);
}

void FoldConstraint::damp(int cell, MeshEquations& equations)
{
    const double next = std::min(factor_[cell] * STIFFEN, MAX_FACTOR);
    addDamping(cell, next - factor_[cell], equations);
    factor_[cell] = next;
}

void FoldConstraint::addTo(MeshEquations& equations) const
{
    for (size_t cell = 0; cell < factor_.size(); ++cell)
        if (factor_[cell] > 1)
            addDamping(static_cast<int>(cell), factor_[cell] - 1, equations);
}

} // namespace gcpw
} // namespace cv
