// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#ifndef OPENCV_GCPW_ROBUST_LOSS_HPP
#define OPENCV_GCPW_ROBUST_LOSS_HPP

#include <limits>

namespace cv
{
namespace gcpw
{

/** @brief Geman-McClure loss of a squared residual s: rho(s) = s / (1 + s / scale^2), at most scale^2.

An infinite scale is the plain sum of squares. */
class RobustLoss
{
public:
    explicit RobustLoss(double scale = std::numeric_limits<double>::infinity()) : inverse_(1 / (scale * scale)) {}

    double value(double squared) const { return squared / (1 + squared * inverse_); }

    /// d rho / d s: the weight of the residual in iteratively re-weighted least squares.
    double weight(double squared) const
    {
        const double w = 1 / (1 + squared * inverse_);
        return w * w;
    }

private:
    double inverse_;
};

} // namespace gcpw
} // namespace cv

#endif
