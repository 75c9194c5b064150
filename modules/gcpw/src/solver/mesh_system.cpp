// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#include "solver/mesh_system.hpp"

#include <algorithm>
#include <cmath>
#include <opencv2/core/utility.hpp>
#include "solver/quad_matrix.hpp"

namespace cv
{
namespace gcpw
{

namespace
{
const int CG_MAX_ITERATIONS = 200;

} // namespace

MeshSystem::MeshSystem(const std::vector<Lattice>& lattices, const std::vector<bool>& fixed) : lattices_(lattices), offsets_(1, 0)
{
    CV_Assert(fixed.size() == lattices.size());
    groups_.resize(lattices.size());
    for (size_t i = 0; i < lattices.size(); ++i)
    {
        matrices_.push_back(fixed[i] ? nullptr : std::make_unique<QuadMatrix>(lattices[i]));
        offsets_.push_back(offsets_.back() + (fixed[i] ? 0 : matrices_[i]->size()));
    }
}

MeshSystem::~MeshSystem() = default;

void MeshSystem::setZero()
{
    for (Tie& tie : ties_)
    {
        tie.matrix.setZero();
        tie.used = false;
    }
    for (LowRank& group : groups_)
        group.clear();
    for (auto& matrix : matrices_)
        if (matrix)
            matrix->setZero();
}

void MeshSystem::addRow(QuadId quad, const QuadRow& row, double residual, double weight)
{
    if (!fixed(quad))
        matrices_[quad.image]->addRow(quad.cell, row, residual, weight);
}

void MeshSystem::addRow(QuadId a, const QuadRow& row_a, QuadId b, const QuadRow& row_b, double residual, double weight)
{
    addRow(a, row_a, residual, weight);
    addRow(b, row_b, residual, weight);
    if (fixed(a) || fixed(b))
        return;
    QuadBlock block;
    for (int i = 0; i < 8; ++i)
        for (int j = 0; j < 8; ++j)
            block[i][j] = weight * row_a[i] * row_b[j];
    tie(a, b, block);
}

void MeshSystem::addBlock(QuadId quad, const QuadBlock& block, const QuadRow& gradient, double)
{
    if (!fixed(quad))
        matrices_[quad.image]->addBlock(quad.cell, block, gradient);
}

void MeshSystem::addGroup(int image, const RowGroup& group, const std::vector<double>& residuals, double weight)
{
    if (!matrices_[image])
        return;
    for (size_t k = 0; k < residuals.size(); ++k)
        matrices_[image]->addRow(group.rows()[k].cell, group.rows()[k].row, residuals[k], weight);
    // The rows count fully above; what their own unknowns follow is taken off again.
    for (const SparseColumn& column : group.followed())
        groups_[image].add(column, std::sqrt(weight));
}

void MeshSystem::addPhotometric(QuadId quad, const PhotometricBlock& block)
{
    addBlock(quad, block.mesh_mesh, block.mesh_gradient, block.energy);
}

void MeshSystem::addCross(QuadId a, QuadId b, const CrossBlock& block)
{
    addBlock(b, block.mesh_mesh, block.mesh_gradient, 0);
    if (!fixed(a) && !fixed(b))
        tie(a, b, block.cross);
}

void MeshSystem::tie(QuadId a, QuadId b, const QuadBlock& block)
{
    auto found = std::find_if(ties_.begin(), ties_.end(), [&](const Tie& t) { return t.a == a.image && t.b == b.image; });
    if (found == ties_.end())
        found = ties_.insert(ties_.end(), {a.image, b.image, CrossMatrix(lattices_[a.image], lattices_[b.image]), true});
    found->matrix.add(a.cell, b.cell, block);
    found->used = true;
}

bool MeshSystem::isDirect() const
{
    return std::all_of(groups_.begin(), groups_.end(), [](const LowRank& group) { return group.empty(); }) &&
           std::none_of(ties_.begin(), ties_.end(), [](const Tie& t) { return t.used; });
}

template <typename Work>
void MeshSystem::forEachMoving(Work work) const
{
    parallel_for_(Range(0, static_cast<int>(matrices_.size())), [&](const Range& range)
    {
        for (int image = range.start; image < range.end; ++image)
            if (matrices_[image])
                work(image);
    });
}

void MeshSystem::addDamping(double weight)
{
    for (auto& matrix : matrices_)
        if (matrix)
            matrix->addDiagonal(weight);
}

void MeshSystem::multiply(const Eigen::VectorXd& in, Eigen::VectorXd& out) const
{
    // By the image that receives: no two threads write to one place, and each sum keeps its order.
    forEachMoving([&](int image)
    {
        const auto part = [this](int i, auto& vector) { return vector.segment(offsets_[i], offsets_[i + 1] - offsets_[i]); };
        auto mine = part(image, out);
        mine.setZero();
        matrices_[image]->multiply(part(image, in), mine);
        groups_[image].subtractProduct(part(image, in), mine);
        for (const Tie& tie : ties_)
        {
            if (tie.a == image)
                tie.matrix.multiply(part(tie.b, in), mine);
            if (tie.b == image)
                tie.matrix.multiplyTransposed(part(tie.a, in), mine);
        }
    });
}

SolveStatus MeshSystem::solve(MeshStep& step, double tolerance)
{
    const auto solveEach = [&](const Eigen::VectorXd& in, Eigen::VectorXd& out)
    {
        out = in;
        forEachMoving([&](int image) { matrices_[image]->solve(out.segment(offsets_[image], matrices_[image]->size())); });
    };
    Eigen::VectorXd rhs = Eigen::VectorXd::Zero(offsets_.back());
    std::vector<char> factorized(matrices_.size(), 1);
    forEachMoving([&](int image)
    {
        factorized[image] = matrices_[image]->factorize() ? 1 : 0;
        matrices_[image]->subtractGradient(rhs.segment(offsets_[image], matrices_[image]->size()));
    });
    if (std::find(factorized.begin(), factorized.end(), 0) != factorized.end())
        return SolveStatus::NotPositiveDefinite;
    Eigen::VectorXd x = Eigen::VectorXd::Zero(rhs.size());
    SolveStatus status = SolveStatus::Solved;
    if (isDirect())
        solveEach(rhs, x);
    else
        status = conjugateGradient(
            rhs, x, [&](const Eigen::VectorXd& in, Eigen::VectorXd& out) { multiply(in, out); }, solveEach, tolerance,
            CG_MAX_ITERATIONS);
    if (status == SolveStatus::NotPositiveDefinite || !x.allFinite())
        return SolveStatus::NotPositiveDefinite;
    step.assign(matrices_.size(), std::vector<Point2d>());
    for (size_t i = 0; i < matrices_.size(); ++i)
        for (int column = offsets_[i]; column < offsets_[i + 1]; column += 2)
            step[i].emplace_back(x[column], x[column + 1]);
    return status;
}

} // namespace gcpw
} // namespace cv
