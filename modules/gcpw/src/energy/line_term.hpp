// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#ifndef OPENCV_GCPW_LINE_TERM_HPP
#define OPENCV_GCPW_LINE_TERM_HPP

#include <vector>
#include "energy/energy_term.hpp"
#include "geometry/matches.hpp"
#include "solver/robust_loss.hpp"

namespace cv
{
namespace gcpw
{

/** @brief Lays matched segments onto each other's line (eq. geometerm, line part).

    E_l = weight * sum_m w_m sum_k rho( (n_m . W_a(s_mk) + c_m)^2 )

s_mk are points every `step` px along segment m of image a; n_m . x + c_m = 0 is the line through the warped ends of its
target in image b, which gives no rows while both ends are one point. With b fixed the line stands still and the term is
linear; else the line is taken as it lies now and moves with the point of b next to the sample. Residuals: 1 per sample, canvas px. */
class LineTerm : public EnergyTerm
{
public:
    /// @param shift_b canvas px by which b is seen beside its own place (a canvas that wraps around)
    LineTerm(int image_a, int image_b, const Lattice& lattice_a, const Lattice& lattice_b,
             const std::vector<LineMatch>& matches, double step_px, double weight, const RobustLoss& loss = RobustLoss(),
             Point2d shift_b = Point2d());

    const char* name() const override { return "lines"; }
    double evaluate(const State& state) const override;
    double linearize(const State& state, NormalEquations& equations) override;

    /// Root mean square distance of every match at present, canvas px, in the order given; infinite without samples and where
    /// the target has no line.
    std::vector<double> distances(const State& state) const;

private:
    struct Target
    {
        std::vector<CellPoint> samples;
        Segment reference_b;
        CellPoint start_b;
        CellPoint end_b;
        double weight = 0;
    };
    /// The target's segment on the canvas; false while it has no direction.
    bool lineNow(const Target& target, const State& state, Segment& segment) const;

    int image_a_;
    int image_b_;
    RobustLoss loss_;
    Point2d shift_b_;
    std::vector<Target> targets_;
};

} // namespace gcpw
} // namespace cv

#endif
