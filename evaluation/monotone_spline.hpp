// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#ifndef GCPW_EVALUATION_MONOTONE_SPLINE_HPP
#define GCPW_EVALUATION_MONOTONE_SPLINE_HPP

#include <array>
#include <vector>
#include <opencv2/core.hpp>

namespace evaluation
{

/// Bounds and weights of a spline fit.
struct SplineOptions
{
    double min_slope = 0.2;     ///< > 0: keeps the curve one-to-one
    double max_slope = 5;       ///< > min_slope: keeps noise in flat regions from growing
    double identity_pull = 1e-6; ///< weight of (slope - 1)^2 and (value at 0)^2 against a mean squared error, > 0
};

/** @brief A monotone quadratic spline of intensities in [0, 1]: continuous, with a slope that is linear between six knots.

    f(x) = offset + integral of the slope from 0 to x */
class MonotoneSpline
{
public:
    static constexpr int KNOTS = 6; ///< at 0, 0.2, .. 1

    /// The identity.
    MonotoneSpline();

    /** @brief The spline with f(x_i) nearest to y_i in the mean square, within the bounds.
    @param x, y as many each, in [0, 1]; none gives the identity
    @throws cv::Exception if counts differ or options are out of range */
    static MonotoneSpline fit(const std::vector<double>& x, const std::vector<double>& y,
                              const SplineOptions& options = SplineOptions());

    double at(double x) const;

    /// Slopes at the knots.
    const std::array<double, KNOTS>& slopes() const { return slopes_; }

private:
    double offset_ = 0;
    std::array<double, KNOTS> slopes_;
};

} // namespace evaluation

#endif
