// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#include "test_precomp.hpp"

#include <Eigen/Cholesky>
#include "solver/conjugate_gradient.hpp"
#include "seeded.hpp"

namespace opencv_test { namespace {

using namespace cv::gcpw;

const int SIZE = 30;

/// J^T J + I of random rows.
Eigen::MatrixXd randomMatrix(uint64_t seed)
{
    RNG rng = seeded(seed);
    Eigen::MatrixXd j(SIZE, SIZE);
    for (int i = 0; i < SIZE * SIZE; ++i)
        j(i / SIZE, i % SIZE) = rng.uniform(-1.0, 1.0);
    return j.transpose() * j + Eigen::MatrixXd::Identity(SIZE, SIZE);
}

Eigen::VectorXd randomVector(uint64_t seed)
{
    RNG rng = seeded(seed);
    Eigen::VectorXd v(SIZE);
    for (int i = 0; i < SIZE; ++i)
        v[i] = rng.uniform(-1.0, 1.0);
    return v;
}

SolveStatus run(const Eigen::MatrixXd& matrix, const Eigen::VectorXd& right, Eigen::VectorXd& x, double tolerance,
                int max_iterations)
{
    return conjugateGradient(
        right, x, [&](const Eigen::VectorXd& in, Eigen::VectorXd& out) { out = matrix * in; },
        [&](const Eigen::VectorXd& in, Eigen::VectorXd& out) { out = in.cwiseQuotient(matrix.diagonal()); }, tolerance,
        max_iterations);
}

TEST(Gcpw_ConjugateGradient, it_solves_what_a_dense_solver_solves_from_any_start)
{
    const Eigen::MatrixXd matrix = randomMatrix(1);
    const Eigen::VectorXd right = randomVector(2);
    const Eigen::VectorXd expected = matrix.llt().solve(right);
    for (const uint64_t seed : {3, 4})
    {
        Eigen::VectorXd x = 5 * randomVector(seed);
        EXPECT_EQ(run(matrix, right, x, 1e-10, 200), SolveStatus::Solved);
        EXPECT_LT((x - expected).norm(), 1e-7 * expected.norm());
    }
}

TEST(Gcpw_ConjugateGradient, a_solution_given_is_left_as_it_is)
{
    const Eigen::MatrixXd matrix = randomMatrix(5);
    const Eigen::VectorXd solution = randomVector(6);
    Eigen::VectorXd x = solution;
    EXPECT_EQ(run(matrix, matrix * solution, x, 1e-6, 200), SolveStatus::Solved);
    EXPECT_EQ(x, solution);
    Eigen::VectorXd zero = Eigen::VectorXd::Zero(SIZE);
    EXPECT_EQ(run(matrix, Eigen::VectorXd::Zero(SIZE), zero, 1e-6, 200), SolveStatus::Solved);
    EXPECT_EQ(zero.norm(), 0);
}

TEST(Gcpw_ConjugateGradient, running_out_of_iterations_says_so_and_still_lowers_the_energy)
{
    const Eigen::MatrixXd matrix = randomMatrix(7);
    const Eigen::VectorXd right = randomVector(8);
    const auto energy = [&](const Eigen::VectorXd& x) { return 0.5 * x.dot(matrix * x) - right.dot(x); };
    Eigen::VectorXd x = Eigen::VectorXd::Zero(SIZE);
    EXPECT_EQ(run(matrix, right, x, 1e-10, 3), SolveStatus::NotConverged);
    EXPECT_LT(energy(x), energy(Eigen::VectorXd::Zero(SIZE)) - 1e-3);
}

TEST(Gcpw_ConjugateGradient, a_matrix_that_is_not_positive_definite_or_not_a_number_is_refused)
{
    Eigen::MatrixXd matrix = randomMatrix(9);
    const Eigen::VectorXd right = randomVector(10);
    Eigen::VectorXd x = Eigen::VectorXd::Zero(SIZE);
    EXPECT_EQ(run(-matrix, right, x, 1e-6, 200), SolveStatus::NotPositiveDefinite);
    Eigen::VectorXd broken = right;
    broken[3] = std::numeric_limits<double>::quiet_NaN();
    x.setZero();
    EXPECT_EQ(run(matrix, broken, x, 1e-6, 200), SolveStatus::NotPositiveDefinite);
    matrix(4, 4) = std::numeric_limits<double>::quiet_NaN();
    x.setZero();
    EXPECT_EQ(run(matrix, right, x, 1e-6, 200), SolveStatus::NotPositiveDefinite);
}

}} // namespace
