// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#ifndef OPENCV_GCPW_CONJUGATE_GRADIENT_HPP
#define OPENCV_GCPW_CONJUGATE_GRADIENT_HPP

#include <cmath>
#include <Eigen/Core>

namespace cv
{
namespace gcpw
{

enum class [[nodiscard]] SolveStatus
{
    Solved,
    NotPositiveDefinite, ///< the data and the regularisers leave an unknown free, or are not finite
    NotConverged         ///< the iteration ran out; the result still lowers the energy
};

/** @brief Preconditioned conjugate gradients for a symmetric positive definite matrix that is only known by its products.
@param rhs right-hand side  @param x start and result
@param multiply (in, out): out = A in  @param precondition (in, out): out ~ A^-1 in
@param tolerance of the residual's preconditioned norm, relative to that of rhs */
template <typename Multiply, typename Precondition>
SolveStatus conjugateGradient(const Eigen::VectorXd& rhs, Eigen::VectorXd& x, Multiply multiply,
                              Precondition precondition, double tolerance, int max_iterations)
{
    Eigen::VectorXd q(rhs.size());
    Eigen::VectorXd z(rhs.size());
    precondition(rhs, z);
    const double stop = tolerance * tolerance * rhs.dot(z);
    Eigen::VectorXd r = rhs;
    if (!x.isZero(0))
    {
        multiply(x, q);
        r -= q;
        precondition(r, z);
    }
    Eigen::VectorXd p = z;
    double rz = r.dot(z);
    for (int iteration = 0; rz > stop && iteration < max_iterations; ++iteration)
    {
        multiply(p, q);
        const double curvature = p.dot(q);
        // Along a direction of no curvature the sum has no minimum; what was found before it still lowers the energy.
        if (!(curvature > 0))
            return iteration > 0 && std::isfinite(curvature) ? SolveStatus::NotConverged : SolveStatus::NotPositiveDefinite;
        const double alpha = rz / curvature;
        x += alpha * p;
        r -= alpha * q;
        precondition(r, z);
        const double next = r.dot(z);
        p = z + (next / rz) * p;
        rz = next;
    }
    // Negative: the preconditioner is not positive definite, so neither is the matrix.
    if (!std::isfinite(rz) || !std::isfinite(stop) || rz < 0 || stop < 0)
        return SolveStatus::NotPositiveDefinite;
    return rz <= stop ? SolveStatus::Solved : SolveStatus::NotConverged;
}

} // namespace gcpw
} // namespace cv

#endif
