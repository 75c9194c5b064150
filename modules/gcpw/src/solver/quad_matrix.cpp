// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#include "solver/quad_matrix.hpp"

#include <algorithm>

namespace cv
{
namespace gcpw
{

QuadMatrix::QuadMatrix(const Lattice& lattice)
    : lattice_(lattice), blocks_(lattice.cellCount()), gradients_(lattice.cellCount()),
      factor_(lattice.rows() + 1, 2 * (lattice.cols() + 1))
{
    setZero();
}

void QuadMatrix::setZero()
{
    diagonal_ = 0;
    std::fill(blocks_.begin(), blocks_.end(), QuadBlock{});
    std::fill(gradients_.begin(), gradients_.end(), QuadRow{});
}

void QuadMatrix::addRow(int cell, const QuadRow& row, double residual, double weight)
{
    QuadBlock& block = blocks_[cell];
    QuadRow& gradient = gradients_[cell];
    for (int i = 0; i < 8; ++i)
    {
        const double w = weight * row[i];
        gradient[i] += w * residual;
        for (int j = i; j < 8; ++j)
            block[i][j] += w * row[j];
    }
}

void QuadMatrix::addBlock(int cell, const QuadBlock& block, const QuadRow& gradient)
{
    for (int i = 0; i < 8; ++i)
    {
        gradients_[cell][i] += gradient[i];
        for (int j = i; j < 8; ++j)
            blocks_[cell][i][j] += block[i][j];
    }
}

bool QuadMatrix::factorize()
{
    factor_.setZero();
    for (int k = 0; k < factor_.blocks(); ++k)
        factor_.diagonal(k).diagonal().setConstant(diagonal_);
    for (int cell = 0; cell < lattice_.cellCount(); ++cell)
    {
        // Corners 0 and 1 are four consecutive columns of one vertex row, corners 2 and 3 of the next.
        const int row = cell / lattice_.cols();
        const int first = 2 * (cell % lattice_.cols());
        const QuadBlock& block = blocks_[cell];
        Eigen::MatrixXd& top = factor_.diagonal(row);
        Eigen::MatrixXd& bottom = factor_.diagonal(row + 1);
        Eigen::MatrixXd& between = factor_.below(row);
        for (int i = 0; i < 4; ++i)
            for (int j = 0; j < 4; ++j)
            {
                if (j >= i)
                {
                    top(first + j, first + i) += block[i][j];
                    bottom(first + j, first + i) += block[i + 4][j + 4];
                }
                between(first + j, first + i) += block[i][j + 4];
            }
    }
    return factor_.factorize();
}

void QuadMatrix::multiply(const Eigen::Ref<const Eigen::VectorXd>& in, Eigen::Ref<Eigen::VectorXd> out) const
{
    out += diagonal_ * in;
    for (int cell = 0; cell < lattice_.cellCount(); ++cell)
    {
        const QuadBlock& block = blocks_[cell];
        double x[8];
        double sum[8] = {};
        for (int k = 0; k < 8; ++k)
            x[k] = in[column(cell, k)];
        for (int i = 0; i < 8; ++i)
        {
            sum[i] += block[i][i] * x[i];
            for (int j = i + 1; j < 8; ++j)
            {
                sum[i] += block[i][j] * x[j];
                sum[j] += block[i][j] * x[i];
            }
        }
        for (int k = 0; k < 8; ++k)
            out[column(cell, k)] += sum[k];
    }
}

void QuadMatrix::subtractGradient(Eigen::Ref<Eigen::VectorXd> out) const
{
    for (int cell = 0; cell < lattice_.cellCount(); ++cell)
        for (int k = 0; k < 8; ++k)
            out[column(cell, k)] -= gradients_[cell][k];
}

} // namespace gcpw
} // namespace cv
