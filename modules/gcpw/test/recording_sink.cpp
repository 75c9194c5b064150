// Part of the GCPW module for OpenCV. Licence: Apache-2.0 (see LICENSE).
#include "recording_sink.hpp"

namespace opencv_test
{

using namespace cv::gcpw;

RecordingSink::RecordingSink(const std::vector<Lattice>& lattices) : lattices_(lattices)
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

void RecordingSink::addRow(QuadId quad, const QuadRow& row, double residual, double weight)
{
    rows.push_back({quad, row, QuadId(), QuadRow{}, residual, weight});
}

void RecordingSink::addRow(QuadId a, const QuadRow& row_a, QuadId b, const QuadRow& row_b, double residual,
                           double weight)
{
    rows.push_back({a, row_a, b, row_b, residual, weight});
}

void RecordingSink::addBlock(QuadId quad, const QuadBlock& block, const QuadRow& gradient, double energy)
{
    Block item;
    item.quad = quad;
    item.block.mesh_mesh = block;
    item.block.mesh_gradient = gradient;
    item.block.energy = energy;
    blocks.push_back(item);
}

void RecordingSink::addColored(QuadId quad, const ColoredBlock& block)
{
    blocks.push_back({quad, block});
}

void RecordingSink::addCross(QuadId a, QuadId b, const QuadBlock& block)
{
    crosses.push_back({a, b, block});
}

int RecordingSink::meshColumn(QuadId quad, int k) const
{
    return first_mesh_[quad.image] + 2 * lattices_[quad.image].vertexOf(quad.cell, k >> 1) + (k & 1);
}

int RecordingSink::colorColumn(QuadId quad, int k) const
{
    return first_color_[quad.image] + 6 * quad.cell + k;
}

double RecordingSink::energy() const
{
    double sum = 0;
    for (const Row& row : rows)
        sum += row.weight * row.residual * row.residual;
    for (const Block& item : blocks)
        sum += item.block.energy;
    return sum;
}

Eigen::VectorXd RecordingSink::gradient() const
{
    Eigen::VectorXd g = Eigen::VectorXd::Zero(columns_);
    for (const Row& row : rows)
        for (int k = 0; k < 8; ++k)
        {
            g[meshColumn(row.a, k)] += row.weight * row.residual * row.row_a[k];
            if (row.b.image >= 0)
                g[meshColumn(row.b, k)] += row.weight * row.residual * row.row_b[k];
        }
    for (const Block& item : blocks)
    {
        for (int k = 0; k < 8; ++k)
            g[meshColumn(item.quad, k)] += item.block.mesh_gradient[k];
        for (int k = 0; k < 6; ++k)
            g[colorColumn(item.quad, k)] += item.block.color_gradient[k / 2][k % 2];
    }
    return g;
}

Eigen::MatrixXd RecordingSink::matrix() const
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
    for (const Block& item : blocks)
    {
        const ColoredBlock& b = item.block;
        for (int i = 0; i < 8; ++i)
        {
            const int row = meshColumn(item.quad, i);
            for (int j = 0; j < 8; ++j)
                m(row, meshColumn(item.quad, j)) += b.mesh_mesh[std::min(i, j)][std::max(i, j)];
            for (int k = 0; k < 6; ++k)
            {
                m(row, colorColumn(item.quad, k)) += b.mesh_color[i][k];
                m(colorColumn(item.quad, k), row) += b.mesh_color[i][k];
            }
        }
        for (int i = 0; i < 6; ++i)
            for (int j = i / 2 * 2; j < i / 2 * 2 + 2; ++j)
                m(colorColumn(item.quad, i), colorColumn(item.quad, j)) += b.color_color[i / 2][i % 2 + j % 2];
    }
    for (const Cross& cross : crosses)
        for (int i = 0; i < 8; ++i)
            for (int j = 0; j < 8; ++j)
            {
                m(meshColumn(cross.a, i), meshColumn(cross.b, j)) += cross.block[i][j];
                m(meshColumn(cross.b, j), meshColumn(cross.a, i)) += cross.block[i][j];
            }
    return m;
}

} // namespace opencv_test
