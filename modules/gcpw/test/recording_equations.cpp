// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#include "recording_equations.hpp"

#include <Eigen/QR>

namespace opencv_test
{

using namespace cv::gcpw;

namespace
{

void addBothWays(int row, int col, double value, Eigen::MatrixXd& m)
{
    m(row, col) += value;
    m(col, row) += value;
}

} // namespace

RecordingEquations::RecordingEquations(const std::vector<Lattice>& lattices) : lattices_(lattices)
{
    for (const Lattice& lattice : lattices)
    {
        first_mesh_.push_back(mesh_columns_);
        mesh_columns_ += 2 * lattice.vertexCount();
    }
    columns_ = mesh_columns_;
    for (const Lattice& lattice : lattices)
    {
        first_color_.push_back(columns_);
        columns_ += 6 * lattice.cellCount();
    }
}

void RecordingEquations::addRow(QuadId quad, const QuadRow& row, double residual, double weight)
{
    rows.push_back({quad, row, QuadId(), QuadRow{}, residual, weight});
}

void RecordingEquations::addRow(QuadId a, const QuadRow& row_a, QuadId b, const QuadRow& row_b, double residual,
                           double weight)
{
    rows.push_back({a, row_a, b, row_b, residual, weight});
}

void RecordingEquations::addBlock(QuadId quad, const QuadBlock& block, const QuadRow& gradient, double energy)
{
    Block item;
    item.quad = quad;
    item.block.mesh_mesh = block;
    item.block.mesh_gradient = gradient;
    item.block.energy = energy;
    blocks.push_back(item);
}

void RecordingEquations::addGroup(int image, const RowGroup& group, const std::vector<double>& residuals, double weight)
{
    groups.push_back({image, group.rows(), residuals, weight});
}

Eigen::MatrixXd RecordingEquations::reduced(const Group& group) const
{
    const Eigen::Index count = static_cast<Eigen::Index>(group.rows.size());
    Eigen::MatrixXd system = Eigen::MatrixXd::Zero(count, columns_ + 1);
    Eigen::MatrixXd own(count, 2);
    for (Eigen::Index k = 0; k < count; ++k)
    {
        const GroupRow& row = group.rows[static_cast<size_t>(k)];
        for (int i = 0; i < 8; ++i)
            system(k, meshColumn({group.image, row.cell}, i)) += row.row[i];
        system(k, columns_) = group.residuals[static_cast<size_t>(k)];
        own(k, 0) = row.shared[0];
        own(k, 1) = row.shared[1];
    }
    return system - own * own.completeOrthogonalDecomposition().solve(system);
}

void RecordingEquations::addPhotometric(QuadId quad, const PhotometricBlock& block)
{
    blocks.push_back({quad, block});
}

void RecordingEquations::addCross(QuadId a, QuadId b, const CrossBlock& block)
{
    targets.push_back({a, b, block});
}

int RecordingEquations::meshColumn(QuadId quad, int k) const
{
    return first_mesh_[quad.image] + 2 * lattices_[quad.image].vertexOf(quad.cell, k >> 1) + (k & 1);
}

int RecordingEquations::colorColumn(QuadId quad, int k) const
{
    return first_color_[quad.image] + 6 * quad.cell + k;
}

double RecordingEquations::energy() const
{
    double sum = 0;
    for (const Row& row : rows)
        sum += row.weight * row.residual * row.residual;
    for (const Block& item : blocks)
        sum += item.block.energy;
    for (const Group& group : groups)
        sum += group.weight * reduced(group).col(columns_).squaredNorm();
    return sum;
}

Eigen::VectorXd RecordingEquations::gradient() const
{
    Eigen::VectorXd g = Eigen::VectorXd::Zero(columns_);
    for (const Row& row : rows)
        for (int k = 0; k < 8; ++k)
        {
            g[meshColumn(row.a, k)] += row.weight * row.residual * row.row_a[k];
            if (row.b.image >= 0)
                g[meshColumn(row.b, k)] += row.weight * row.residual * row.row_b[k];
        }
    for (const Group& group : groups)
    {
        const Eigen::MatrixXd system = reduced(group);
        g += group.weight * system.leftCols(columns_).transpose() * system.col(columns_);
    }
    for (const Block& item : blocks)
    {
        for (int k = 0; k < 8; ++k)
            g[meshColumn(item.quad, k)] += item.block.mesh_gradient[k];
        for (int k = 0; k < 6; ++k)
            g[colorColumn(item.quad, k)] += item.block.color_gradient[k / 2][k % 2];
    }
    for (const Target& item : targets)
    {
        for (int k = 0; k < 8; ++k)
            g[meshColumn(item.b, k)] += item.block.mesh_gradient[k];
        for (int k = 0; k < 6; ++k)
            g[colorColumn(item.b, k)] += item.block.color_gradient[k / 2][k % 2];
    }
    return g;
}

void RecordingEquations::addOwn(QuadId quad, const QuadBlock& mesh, const std::array<std::array<double, 3>, 3>& color,
                           Eigen::MatrixXd& m) const
{
    for (int i = 0; i < 8; ++i)
        for (int j = 0; j < 8; ++j)
            m(meshColumn(quad, i), meshColumn(quad, j)) += mesh[std::min(i, j)][std::max(i, j)];
    for (int c = 0; c < 3; ++c)
        for (int i = 0; i < 2; ++i)
            for (int j = 0; j < 2; ++j)
                m(colorColumn(quad, 2 * c + i), colorColumn(quad, 2 * c + j)) += color[c][i + j];
}

Eigen::MatrixXd RecordingEquations::matrix() const
{
    Eigen::MatrixXd m = Eigen::MatrixXd::Zero(columns_, columns_);
    for (const Row& row : rows)
    {
        Eigen::VectorXd jacobian = Eigen::VectorXd::Zero(columns_);
        for (int k = 0; k < 8; ++k)
        {
            jacobian[meshColumn(row.a, k)] += row.row_a[k];
            if (row.b.image >= 0)
                jacobian[meshColumn(row.b, k)] += row.row_b[k];
        }
        m += row.weight * jacobian * jacobian.transpose();
    }
    for (const Group& group : groups)
    {
        const Eigen::MatrixXd jacobian = reduced(group).leftCols(columns_);
        m += group.weight * jacobian.transpose() * jacobian;
    }
    for (const Block& item : blocks)
    {
        addOwn(item.quad, item.block.mesh_mesh, item.block.color_color, m);
        for (int i = 0; i < 8; ++i)
            for (int k = 0; k < 6; ++k)
                addBothWays(meshColumn(item.quad, i), colorColumn(item.quad, k), item.block.mesh_color[i][k], m);
    }
    for (const Target& item : targets)
    {
        addOwn(item.b, item.block.mesh_mesh, item.block.color_color, m);
        for (int i = 0; i < 8; ++i)
            for (int j = 0; j < 8; ++j)
                addBothWays(meshColumn(item.a, i), meshColumn(item.b, j), item.block.cross[i][j], m);
        for (int c = 0; c < 3; ++c)
            for (int k = 0; k < 4; ++k)
                addBothWays(colorColumn(item.a, 2 * c + k / 2), colorColumn(item.b, 2 * c + k % 2),
                            item.block.color_cross[c][k], m);
    }
    return m;
}

void RecordingEquations::addColorDifference(QuadId a, QuadId b, const ColorBlock& block)
{
    differences.push_back({a, b, block});
}

void RecordingEquations::addColorPrior(QuadId quad, double weight, const ColorGrid::Quad& reference)
{
    priors.push_back({quad, weight, reference});
}

} // namespace opencv_test
