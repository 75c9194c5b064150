// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#ifndef OPENCV_GCPW_PERF_SPARSE_REFERENCE_HPP
#define OPENCV_GCPW_PERF_SPARSE_REFERENCE_HPP

#include "perf_precomp.hpp"

#include <Eigen/SparseCholesky>
#include "pair_problem.hpp"

namespace opencv_test
{

/** @brief The textbook solver of the same normal equations: one sparse matrix of all unknowns, Eigen's LDL^T.

Its matrix is assembled and its ordering chosen beforehand, so that solve() is the numbers alone. */
class SparseReference
{
public:
    enum Unknowns
    {
        MESHES,            ///< 2178 an image
        MESHES_AND_COLORS, ///< 8322 an image, with the smoothness of colours
    };
    SparseReference(const PairProblem& problem, Unknowns unknowns, double damping);

    /// Factorises and solves; false if the matrix is not positive definite.
    bool solve(Eigen::VectorXd& step);

    int unknowns() const { return static_cast<int>(matrix_.cols()); }
    const Eigen::SparseMatrix<double>& lowerTriangle() const { return matrix_; }
    Eigen::VectorXd right() const { return -gradient_; }
    /// The energy of a step, up to a constant: what a solver makes small.
    double energy(const Eigen::VectorXd& step) const;

private:
    Eigen::SparseMatrix<double> matrix_; ///< lower triangle
    Eigen::VectorXd gradient_;
    Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> solver_;
};

} // namespace opencv_test

#endif
