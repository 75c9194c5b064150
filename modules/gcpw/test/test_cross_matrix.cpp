// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#include "test_precomp.hpp"

#include <Eigen/Core>
#include "solver/cross_matrix.hpp"
#include "random_problem.hpp"

namespace opencv_test { namespace {

using namespace cv::gcpw;

const Lattice ROWS(Size(80, 60), 4, 3);
const Lattice COLS(Size(50, 70), 2, 5);

/// Random blocks into a matrix and, entry by entry, into a dense one.
Eigen::MatrixXd fill(CrossMatrix& matrix, uint64_t seed)
{
    RNG rng = seeded(seed);
    Eigen::MatrixXd dense = Eigen::MatrixXd::Zero(2 * ROWS.vertexCount(), 2 * COLS.vertexCount());
    for (int n = 0; n < 200; ++n)
    {
        const int row_cell = rng.uniform(0, ROWS.cellCount());
        const int col_cell = rng.uniform(0, COLS.cellCount());
        QuadBlock block;
        for (auto& line : block)
            line = randomRow(rng);
        matrix.add(row_cell, col_cell, block);
        for (int i = 0; i < 8; ++i)
            for (int j = 0; j < 8; ++j)
                dense(2 * ROWS.vertexOf(row_cell, i >> 1) + (i & 1), 2 * COLS.vertexOf(col_cell, j >> 1) + (j & 1)) += block[i][j];
    }
    return dense;
}

TEST(Gcpw_CrossMatrix, products_are_those_of_the_dense_sum)
{
    CrossMatrix matrix(ROWS, COLS);
    const Eigen::MatrixXd dense = fill(matrix, 1);
    const Eigen::VectorXd over_cols = Eigen::VectorXd::LinSpaced(dense.cols(), -1, 2);
    const Eigen::VectorXd over_rows = Eigen::VectorXd::LinSpaced(dense.rows(), 3, -1);
    Eigen::VectorXd rows = Eigen::VectorXd::Ones(dense.rows());
    matrix.multiply(over_cols, rows);
    EXPECT_LT((rows - Eigen::VectorXd::Ones(dense.rows()) - dense * over_cols).norm(), 1e-10 * rows.norm());
    Eigen::VectorXd cols = Eigen::VectorXd::Ones(dense.cols());
    matrix.multiplyTransposed(over_rows, cols);
    EXPECT_LT((cols - Eigen::VectorXd::Ones(dense.cols()) - dense.transpose() * over_rows).norm(), 1e-10 * cols.norm());
}

TEST(Gcpw_CrossMatrix, zero_forgets_what_was_added)
{
    CrossMatrix matrix(ROWS, COLS);
    fill(matrix, 2);
    matrix.setZero();
    const Eigen::MatrixXd dense = fill(matrix, 3);
    Eigen::VectorXd rows = Eigen::VectorXd::Zero(dense.rows());
    const Eigen::VectorXd over_cols = Eigen::VectorXd::Ones(dense.cols());
    matrix.multiply(over_cols, rows);
    EXPECT_LT((rows - dense * over_cols).norm(), 1e-10 * rows.norm());
}

}} // namespace
