// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#include "test_precomp.hpp"

#include <Eigen/Cholesky>
#include "solver/block_tridiagonal.hpp"
#include "seeded.hpp"

namespace opencv_test { namespace {

using namespace cv::gcpw;

Eigen::MatrixXd randomMatrix(RNG& rng, int rows, int cols)
{
    Eigen::MatrixXd m(rows, cols);
    for (int i = 0; i < rows; ++i)
        for (int j = 0; j < cols; ++j)
            m(i, j) = rng.uniform(-1.0, 1.0);
    return m;
}

/// J^T J of rows that each touch two neighbouring blocks, plus a little on the diagonal.
Eigen::MatrixXd randomBand(int blocks, int size, uint64_t seed)
{
    RNG rng = seeded(seed);
    Eigen::MatrixXd dense = 0.1 * Eigen::MatrixXd::Identity(blocks * size, blocks * size);
    for (int k = 0; k + 1 < blocks; ++k)
    {
        const Eigen::MatrixXd rows = randomMatrix(rng, 3 * size, 2 * size);
        dense.block(k * size, k * size, 2 * size, 2 * size) += rows.transpose() * rows;
    }
    return dense;
}

void fill(BlockTridiagonal& matrix, const Eigen::MatrixXd& dense)
{
    const int n = matrix.blockSize();
    for (int k = 0; k < matrix.blocks(); ++k)
    {
        matrix.diagonal(k) = dense.block(k * n, k * n, n, n);
        // Only the lower triangle may be read.
        matrix.diagonal(k).triangularView<Eigen::StrictlyUpper>().setConstant(1e30);
        if (k + 1 < matrix.blocks())
            matrix.below(k) = dense.block((k + 1) * n, k * n, n, n);
    }
}

TEST(Gcpw_BlockTridiagonal, it_solves_what_a_dense_solver_solves)
{
    for (const int blocks : {1, 2, 7})
    {
        const Eigen::MatrixXd dense = randomBand(blocks, 6, 1);
        RNG rng = seeded(2);
        const Eigen::VectorXd right = randomMatrix(rng, blocks * 6, 1);
        BlockTridiagonal matrix(blocks, 6);
        fill(matrix, dense);
        ASSERT_TRUE(matrix.factorize());
        Eigen::VectorXd x = right;
        matrix.solve(x);
        EXPECT_LT((x - dense.llt().solve(right)).norm(), 1e-9 * x.norm()) << blocks;
    }
}

TEST(Gcpw_BlockTridiagonal, one_factor_serves_many_right_hand_sides)
{
    const Eigen::MatrixXd dense = randomBand(5, 4, 3);
    BlockTridiagonal matrix(5, 4);
    fill(matrix, dense);
    ASSERT_TRUE(matrix.factorize());
    RNG rng = seeded(4);
    for (int i = 0; i < 3; ++i)
    {
        const Eigen::VectorXd right = randomMatrix(rng, 20, 1);
        Eigen::VectorXd x = right;
        matrix.solve(x);
        EXPECT_LT((dense * x - right).norm(), 1e-9 * right.norm());
    }
}

TEST(Gcpw_BlockTridiagonal, a_matrix_that_is_not_positive_definite_is_refused)
{
    BlockTridiagonal matrix(3, 2);
    EXPECT_FALSE(matrix.factorize()) << "zero";
    const Eigen::MatrixXd good = Eigen::MatrixXd::Identity(6, 6);
    for (const double bad :
         {-1.0, 0.0, std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()})
    {
        Eigen::MatrixXd dense = good;
        dense(3, 3) = bad;
        fill(matrix, dense);
        EXPECT_FALSE(matrix.factorize()) << bad;
    }
    Eigen::MatrixXd coupled = good;
    coupled(4, 3) = coupled(3, 4) = 1.01; // indefinite through the block between
    fill(matrix, coupled);
    EXPECT_FALSE(matrix.factorize());
    fill(matrix, good);
    EXPECT_TRUE(matrix.factorize());
}

TEST(Gcpw_BlockTridiagonal, set_to_zero_it_forgets)
{
    BlockTridiagonal matrix(2, 2);
    matrix.diagonal(0).setConstant(3);
    matrix.below(0).setConstant(2);
    matrix.setZero();
    EXPECT_EQ(matrix.diagonal(0).norm(), 0);
    EXPECT_EQ(matrix.below(0).norm(), 0);
}

}} // namespace
