// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#include "solver/cross_matrix.hpp"

#include <algorithm>

namespace cv
{
namespace gcpw
{

CrossMatrix::CrossMatrix(const Lattice& rows, const Lattice& cols)
    : rows_(rows), cols_(cols), entries_(rows.vertexCount())
{
}

void CrossMatrix::setZero()
{
    for (std::vector<Entry>& row : entries_)
        row.clear();
}

void CrossMatrix::add(int row_cell, int col_cell, const QuadBlock& block)
{
    for (int k = 0; k < 4; ++k)
    {
        std::vector<Entry>& row = entries_[rows_.vertexOf(row_cell, k)];
        for (int m = 0; m < 4; ++m)
        {
            const int col = cols_.vertexOf(col_cell, m);
            auto entry = std::find_if(row.begin(), row.end(), [col](const Entry& e) { return e.col == col; });
            if (entry == row.end())
                entry = row.insert(row.end(), {col, Eigen::Matrix2d::Zero()});
            for (int i = 0; i < 2; ++i)
                for (int j = 0; j < 2; ++j)
                    entry->block(i, j) += block[2 * k + i][2 * m + j];
        }
    }
}

void CrossMatrix::multiply(const Eigen::Ref<const Eigen::VectorXd>& in, Eigen::Ref<Eigen::VectorXd> out) const
{
    for (size_t row = 0; row < entries_.size(); ++row)
    {
        Eigen::Vector2d sum = Eigen::Vector2d::Zero();
        for (const Entry& entry : entries_[row])
            sum += entry.block * in.segment<2>(2 * entry.col);
        out.segment<2>(2 * static_cast<Eigen::Index>(row)) += sum;
    }
}

void CrossMatrix::multiplyTransposed(const Eigen::Ref<const Eigen::VectorXd>& in, Eigen::Ref<Eigen::VectorXd> out) const
{
    for (size_t row = 0; row < entries_.size(); ++row)
    {
        const Eigen::Vector2d x = in.segment<2>(2 * static_cast<Eigen::Index>(row));
        for (const Entry& entry : entries_[row])
            out.segment<2>(2 * entry.col) += entry.block.transpose() * x;
    }
}

} // namespace gcpw
} // namespace cv
