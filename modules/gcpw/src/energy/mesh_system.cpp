// Part of the GCPW module for OpenCV. Licence: Apache-2.0 (see LICENSE).
#include "energy/mesh_system.hpp"

#include "energy/block_tridiagonal.hpp"

namespace cv
{
namespace gcpw
{

namespace
{

const double CG_TOLERANCE = 1e-4; ///< relative residual; a Gauss-Newton step needs no more
const int CG_MAX_ITERATIONS = 100;

void addOuter(QuadBlock& block, const QuadRow& row, double weight)
{
    for (int i = 0; i < 8; ++i)
    {
        const double w = weight * row[i];
        for (int j = i; j < 8; ++j)
            block[i][j] += w * row[j];
    }
}

} // namespace

struct MeshSystem::Image
{
    Lattice lattice;
    bool held = false;
    std::vector<QuadBlock> blocks; ///< upper triangles, one per cell
    std::vector<QuadRow> gradients;
    double damping = 0;
    std::unique_ptr<BlockTridiagonal> matrix;

    int column(int cell, int k) const { return 2 * lattice.vertexOf(cell, k >> 1) + (k & 1); }

    void assemble()
    {
        const int size = 2 * (lattice.cols() + 1);
        if (!matrix)
            matrix.reset(new BlockTridiagonal(lattice.rows() + 1, size));
        matrix->setZero();
        for (int k = 0; k < matrix->blocks(); ++k)
            matrix->diagonal(k).diagonal().setConstant(damping);
        for (int cell = 0; cell < lattice.cellCount(); ++cell)
        {
            const int row = cell / lattice.cols();
            const int first = 2 * (cell % lattice.cols());
            const QuadBlock& block = blocks[cell];
            Eigen::MatrixXd& top = matrix->diagonal(row);
            Eigen::MatrixXd& bottom = matrix->diagonal(row + 1);
            Eigen::MatrixXd& between = matrix->below(row);
            for (int i = 0; i < 4; ++i)
                for (int j = i; j < 4; ++j)
                {
                    top(first + j, first + i) += block[i][j];
                    bottom(first + j, first + i) += block[i + 4][j + 4];
                }
            for (int i = 0; i < 4; ++i)
                for (int j = 0; j < 4; ++j)
                    between(first + j, first + i) += block[i][j + 4];
        }
    }

    Eigen::VectorXd rightHandSide() const
    {
        Eigen::VectorXd rhs = Eigen::VectorXd::Zero(2 * lattice.vertexCount());
        for (int cell = 0; cell < lattice.cellCount(); ++cell)
            for (int k = 0; k < 8; ++k)
                rhs[column(cell, k)] -= gradients[cell][k];
        return rhs;
    }

    /// out += (own blocks) * x
    void multiply(const Eigen::VectorXd& x, Eigen::VectorXd& out) const
    {
        out += damping * x;
        for (int cell = 0; cell < lattice.cellCount(); ++cell)
        {
            double in[8];
            double sum[8] = {0, 0, 0, 0, 0, 0, 0, 0};
            for (int k = 0; k < 8; ++k)
                in[k] = x[column(cell, k)];
            const QuadBlock& block = blocks[cell];
            for (int i = 0; i < 8; ++i)
            {
                sum[i] += block[i][i] * in[i];
                for (int j = i + 1; j < 8; ++j)
                {
                    sum[i] += block[i][j] * in[j];
                    sum[j] += block[i][j] * in[i];
                }
            }
            for (int k = 0; k < 8; ++k)
                out[column(cell, k)] += sum[k];
        }
    }
};

struct MeshSystem::Cross
{
    QuadId a;
    QuadId b;
    QuadBlock block;
};

MeshSystem::MeshSystem(const std::vector<Lattice>& lattices, const std::vector<bool>& held) : images_(lattices.size())
{
    CV_Assert(held.size() == lattices.size());
    for (size_t i = 0; i < lattices.size(); ++i)
    {
        images_[i].lattice = lattices[i];
        images_[i].held = held[i];
        if (!held[i])
        {
            images_[i].blocks.resize(lattices[i].cellCount());
            images_[i].gradients.resize(lattices[i].cellCount());
        }
    }
    setZero();
}

MeshSystem::~MeshSystem() = default;

void MeshSystem::setZero()
{
    cross_.clear();
    for (Image& image : images_)
    {
        image.damping = 0;
        std::fill(image.blocks.begin(), image.blocks.end(), QuadBlock{});
        std::fill(image.gradients.begin(), image.gradients.end(), QuadRow{});
    }
}

void MeshSystem::addRow(QuadId quad, const QuadRow& row, double residual, double weight)
{
    Image& image = images_[quad.image];
    if (image.held)
        return;
    addOuter(image.blocks[quad.cell], row, weight);
    for (int k = 0; k < 8; ++k)
        image.gradients[quad.cell][k] += weight * residual * row[k];
}

void MeshSystem::addRow(QuadId a, const QuadRow& row_a, QuadId b, const QuadRow& row_b, double residual, double weight)
{
    addRow(a, row_a, residual, weight);
    addRow(b, row_b, residual, weight);
    if (images_[a.image].held || images_[b.image].held)
        return;
    QuadBlock block;
    for (int i = 0; i < 8; ++i)
        for (int j = 0; j < 8; ++j)
            block[i][j] = weight * row_a[i] * row_b[j];
    addCross(a, b, block);
}

void MeshSystem::addBlock(QuadId quad, const QuadBlock& block, const QuadRow& gradient, double)
{
    Image& image = images_[quad.image];
    if (image.held)
        return;
    for (int i = 0; i < 8; ++i)
    {
        image.gradients[quad.cell][i] += gradient[i];
        for (int j = i; j < 8; ++j)
            image.blocks[quad.cell][i][j] += block[i][j];
    }
}

void MeshSystem::addColored(QuadId quad, const ColoredBlock& block)
{
    addBlock(quad, block.mesh_mesh, block.mesh_gradient, block.energy);
}

void MeshSystem::addCross(QuadId a, QuadId b, const QuadBlock& block)
{
    if (images_[a.image].held || images_[b.image].held)
        return;
    // Terms visit a quad at a time, so equal pairs mostly come together.
    if (!cross_.empty() && cross_.back().a.cell == a.cell && cross_.back().b.cell == b.cell &&
        cross_.back().a.image == a.image && cross_.back().b.image == b.image)
    {
        for (int i = 0; i < 8; ++i)
            for (int j = 0; j < 8; ++j)
                cross_.back().block[i][j] += block[i][j];
        return;
    }
    cross_.push_back({a, b, block});
}

void MeshSystem::addDamping(double weight)
{
    for (Image& image : images_)
        image.damping += weight;
}

SolveStatus MeshSystem::solve(MeshStep& step)
{
    const size_t count = images_.size();
    std::vector<Eigen::VectorXd> x(count);
    for (size_t i = 0; i < count; ++i)
    {
        Image& image = images_[i];
        if (image.held)
            continue;
        image.assemble();
        if (!image.matrix->factorize())
            return SolveStatus::NotPositiveDefinite;
        x[i] = image.rightHandSide();
    }

    SolveStatus status = SolveStatus::Solved;
    if (cross_.empty())
    {
        for (size_t i = 0; i < count; ++i)
            if (!images_[i].held)
                images_[i].matrix->solve(x[i]);
    }
    else
    {
        // Conjugate gradients over all images; each image's own factor is the preconditioner.
        const auto dot = [&](const std::vector<Eigen::VectorXd>& p, const std::vector<Eigen::VectorXd>& q)
        {
            double sum = 0;
            for (size_t i = 0; i < count; ++i)
                if (!images_[i].held)
                    sum += p[i].dot(q[i]);
            return sum;
        };
        const auto precondition = [&](const std::vector<Eigen::VectorXd>& in)
        {
            std::vector<Eigen::VectorXd> out = in;
            for (size_t i = 0; i < count; ++i)
                if (!images_[i].held)
                    images_[i].matrix->solve(out[i]);
            return out;
        };
        const auto multiply = [&](const std::vector<Eigen::VectorXd>& in)
        {
            std::vector<Eigen::VectorXd> out(count);
            for (size_t i = 0; i < count; ++i)
                if (!images_[i].held)
                {
                    out[i] = Eigen::VectorXd::Zero(in[i].size());
                    images_[i].multiply(in[i], out[i]);
                }
            for (const Cross& cross : cross_)
            {
                const Image& a = images_[cross.a.image];
                const Image& b = images_[cross.b.image];
                for (int i = 0; i < 8; ++i)
                {
                    const int row = a.column(cross.a.cell, i);
                    double sum = 0;
                    for (int j = 0; j < 8; ++j)
                    {
                        const int col = b.column(cross.b.cell, j);
                        sum += cross.block[i][j] * in[cross.b.image][col];
                        out[cross.b.image][col] += cross.block[i][j] * in[cross.a.image][row];
                    }
                    out[cross.a.image][row] += sum;
                }
            }
            return out;
        };
        std::vector<Eigen::VectorXd> r = x;
        for (size_t i = 0; i < count; ++i)
            x[i].setZero();
        std::vector<Eigen::VectorXd> z = precondition(r);
        std::vector<Eigen::VectorXd> p = z;
        double rz = dot(r, z);
        const double stop = CG_TOLERANCE * CG_TOLERANCE * rz;
        int iteration = 0;
        for (; rz > stop && iteration < CG_MAX_ITERATIONS; ++iteration)
        {
            const std::vector<Eigen::VectorXd> q = multiply(p);
            const double curvature = dot(p, q);
            if (!(curvature > 0))
                return SolveStatus::NotPositiveDefinite;
            const double alpha = rz / curvature;
            for (size_t i = 0; i < count; ++i)
                if (!images_[i].held)
                {
                    x[i] += alpha * p[i];
                    r[i] -= alpha * q[i];
                }
            z = precondition(r);
            const double next = dot(r, z);
            for (size_t i = 0; i < count; ++i)
                if (!images_[i].held)
                    p[i] = z[i] + (next / rz) * p[i];
            rz = next;
        }
        if (rz > stop)
            status = SolveStatus::NotConverged;
    }

    step.assign(count, std::vector<Point2d>());
    for (size_t i = 0; i < count; ++i)
    {
        if (images_[i].held)
            continue;
        if (!x[i].allFinite())
            return SolveStatus::NotPositiveDefinite;
        step[i].resize(images_[i].lattice.vertexCount());
        for (int v = 0; v < images_[i].lattice.vertexCount(); ++v)
            step[i][v] = Point2d(x[i][2 * v], x[i][2 * v + 1]);
    }
    return status;
}

} // namespace gcpw
} // namespace cv
