// Part of the GCPW module for OpenCV. Licence: Apache-2.0 (see LICENSE).
#include "energy/mesh_system.hpp"

#include "energy/quad_matrix.hpp"

namespace cv
{
namespace gcpw
{

namespace
{

const double CG_TOLERANCE = 1e-4; ///< a Gauss-Newton step needs no more
const int CG_MAX_ITERATIONS = 200;

} // namespace

MeshSystem::MeshSystem(const std::vector<Lattice>& lattices, const std::vector<bool>& held) : offsets_(1, 0)
{
    CV_Assert(held.size() == lattices.size());
    for (size_t i = 0; i < lattices.size(); ++i)
    {
        matrices_.push_back(held[i] ? nullptr : std::make_unique<QuadMatrix>(lattices[i]));
        offsets_.push_back(offsets_.back() + (held[i] ? 0 : matrices_[i]->size()));
    }
}

MeshSystem::~MeshSystem() = default;

void MeshSystem::setZero()
{
    ties_.clear();
    for (auto& matrix : matrices_)
        if (matrix)
            matrix->setZero();
}

void MeshSystem::addRow(QuadId quad, const QuadRow& row, double residual, double weight)
{
    if (!held(quad))
        matrices_[quad.image]->addRow(quad.cell, row, residual, weight);
}

void MeshSystem::addRow(QuadId a, const QuadRow& row_a, QuadId b, const QuadRow& row_b, double residual, double weight)
{
    addRow(a, row_a, residual, weight);
    addRow(b, row_b, residual, weight);
    if (held(a) || held(b))
        return;
    QuadBlock block;
    for (int i = 0; i < 8; ++i)
        for (int j = 0; j < 8; ++j)
            block[i][j] = weight * row_a[i] * row_b[j];
    tie(a, b, block);
}

void MeshSystem::addBlock(QuadId quad, const QuadBlock& block, const QuadRow& gradient, double)
{
    if (!held(quad))
        matrices_[quad.image]->addBlock(quad.cell, block, gradient);
}

void MeshSystem::addColored(QuadId quad, const ColoredBlock& block)
{
    addBlock(quad, block.mesh_mesh, block.mesh_gradient, block.energy);
}

void MeshSystem::addPartner(QuadId a, QuadId b, const PartnerBlock& block)
{
    addBlock(b, block.mesh_mesh, block.mesh_gradient, 0);
    if (!held(a) && !held(b))
        tie(a, b, block.cross);
}

void MeshSystem::tie(QuadId a, QuadId b, const QuadBlock& block)
{
    // The two rows of a point come one after the other: one tie for both.
    const bool same = !ties_.empty() && ties_.back().a.image == a.image && ties_.back().a.cell == a.cell &&
                      ties_.back().b.image == b.image && ties_.back().b.cell == b.cell;
    if (!same)
    {
        ties_.push_back({a, b, block});
        return;
    }
    for (int i = 0; i < 8; ++i)
        for (int j = 0; j < 8; ++j)
            ties_.back().block[i][j] += block[i][j];
}

void MeshSystem::addDamping(double weight)
{
    for (auto& matrix : matrices_)
        if (matrix)
            matrix->addDiagonal(weight);
}

void MeshSystem::multiply(const Eigen::VectorXd& in, Eigen::VectorXd& out) const
{
    out.setZero();
    for (size_t i = 0; i < matrices_.size(); ++i)
        if (matrices_[i])
            matrices_[i]->multiply(in.segment(offsets_[i], matrices_[i]->size()),
                                   out.segment(offsets_[i], matrices_[i]->size()));
    for (const Tie& tie : ties_)
    {
        int rows[8];
        int cols[8];
        double x[8];
        double sum[8] = {};
        for (int k = 0; k < 8; ++k)
        {
            rows[k] = offsets_[tie.a.image] + matrices_[tie.a.image]->column(tie.a.cell, k);
            cols[k] = offsets_[tie.b.image] + matrices_[tie.b.image]->column(tie.b.cell, k);
            x[k] = in[cols[k]];
        }
        for (int i = 0; i < 8; ++i)
        {
            const double y = in[rows[i]];
            double dot = 0;
            for (int j = 0; j < 8; ++j)
            {
                dot += tie.block[i][j] * x[j];
                sum[j] += tie.block[i][j] * y;
            }
            out[rows[i]] += dot;
        }
        for (int k = 0; k < 8; ++k)
            out[cols[k]] += sum[k];
    }
}

SolveStatus MeshSystem::solve(MeshStep& step)
{
    const auto solveEach = [&](const Eigen::VectorXd& in, Eigen::VectorXd& out)
    {
        out = in;
        for (size_t i = 0; i < matrices_.size(); ++i)
            if (matrices_[i])
                matrices_[i]->solve(out.segment(offsets_[i], matrices_[i]->size()));
    };
    Eigen::VectorXd rhs = Eigen::VectorXd::Zero(offsets_.back());
    for (size_t i = 0; i < matrices_.size(); ++i)
    {
        if (!matrices_[i])
            continue;
        if (!matrices_[i]->factorize())
            return SolveStatus::NotPositiveDefinite;
        matrices_[i]->subtractGradient(rhs.segment(offsets_[i], matrices_[i]->size()));
    }
    Eigen::VectorXd x = Eigen::VectorXd::Zero(rhs.size());
    SolveStatus status = SolveStatus::Solved;
    if (ties_.empty())
        solveEach(rhs, x);
    else
        status = conjugateGradient(
            rhs, x, [&](const Eigen::VectorXd& in, Eigen::VectorXd& out) { multiply(in, out); }, solveEach, CG_TOLERANCE,
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
