// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#include "evaluation/monotone_spline.hpp"

#include <algorithm>
#include <cmath>

namespace evaluation
{

namespace
{

const int UNKNOWNS = MonotoneSpline::KNOTS + 1; ///< the offset, then the slopes
const double SPAN = 1.0 / (MonotoneSpline::KNOTS - 1);
const int MAX_SWEEPS = 20000;
const double STILL = 1e-12; ///< a sweep that changes no unknown by more than this is the last

typedef cv::Vec<double, UNKNOWNS> Row;

/// f(x) as a linear function of the unknowns: 1 for the offset, the integral of each knot's hat from 0 to x for its slope.
Row rowAt(double x)
{
    Row row = Row::all(0);
    row[0] = 1;
    for (int k = 0; k + 1 < MonotoneSpline::KNOTS; ++k)
    {
        const double t = std::min(std::max(x / SPAN - k, 0.0), 1.0);
        row[1 + k] += SPAN * (t - 0.5 * t * t);
        row[2 + k] += SPAN * 0.5 * t * t;
    }
    return row;
}

} // namespace

MonotoneSpline::MonotoneSpline()
{
    slopes_.fill(1);
}

double MonotoneSpline::at(double x) const
{
    const Row row = rowAt(x);
    double value = offset_;
    for (int k = 0; k < KNOTS; ++k)
        value += row[1 + k] * slopes_[k];
    return value;
}

MonotoneSpline MonotoneSpline::fit(const std::vector<double>& x, const std::vector<double>& y, const SplineOptions& options)
{
    CV_CheckEQ(x.size(), y.size(), "a spline is fitted to pairs of values");
    CV_CheckGT(options.min_slope, 0.0, "SplineOptions::min_slope is above 0");
    CV_CheckGT(options.max_slope, options.min_slope, "SplineOptions::max_slope is above min_slope");
    CV_CheckGT(options.identity_pull, 0.0, "SplineOptions::identity_pull is above 0");
    MonotoneSpline spline;
    if (x.empty())
        return spline;
    cv::Matx<double, UNKNOWNS, UNKNOWNS> normal = cv::Matx<double, UNKNOWNS, UNKNOWNS>::eye() * options.identity_pull;
    Row right = Row::all(options.identity_pull);
    right[0] = 0;
    for (size_t i = 0; i < x.size(); ++i)
    {
        const Row row = rowAt(x[i]);
        normal += row * row.t() * (1.0 / static_cast<double>(x.size()));
        right += row * (y[i] / static_cast<double>(x.size()));
    }
    // A convex problem with bounds: setting one unknown after the other to its bounded best goes to the optimum.
    Row unknowns = Row::all(1);
    unknowns[0] = 0;
    for (int sweep = 0; sweep < MAX_SWEEPS; ++sweep)
    {
        double change = 0;
        for (int i = 0; i < UNKNOWNS; ++i)
        {
            double rest = right[i];
            for (int j = 0; j < UNKNOWNS; ++j)
                rest -= j == i ? 0 : normal(i, j) * unknowns[j];
            double best = rest / normal(i, i);
            if (i > 0)
                best = std::min(std::max(best, options.min_slope), options.max_slope);
            change = std::max(change, std::abs(best - unknowns[i]));
            unknowns[i] = best;
        }
        if (change < STILL)
            break;
    }
    spline.offset_ = unknowns[0];
    std::copy(unknowns.val + 1, unknowns.val + UNKNOWNS, spline.slopes_.begin());
    return spline;
}

} // namespace evaluation
