// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#ifndef OPENCV_GCPW_POINT_TERM_HPP
#define OPENCV_GCPW_POINT_TERM_HPP

#include <vector>
#include "energy/energy_term.hpp"
#include "geometry/matches.hpp"
#include "solver/robust_loss.hpp"

namespace cv
{
namespace gcpw
{

/** @brief Brings matched points together on the canvas (eq. geometerm, point part).

    E_f = weight * sum_k w_k rho( | W_a(p_k) - W_b(p'_k) |^2 )

p_k, p'_k are reference points of images a and b; with b fixed and undeformed W_b(p'_k) is the paper's fixed p'. Linear in both
meshes: but for the loss one linearisation is exact. Residuals: 2 per match, canvas px. */
class PointTerm : public EnergyTerm
{
public:
    /// @param shift_b canvas px by which b is seen beside its own place (a canvas that wraps around)
    PointTerm(int image_a, int image_b, const Lattice& lattice_a, const Lattice& lattice_b,
              const std::vector<PointMatch>& matches, double weight, const RobustLoss& loss = RobustLoss(),
              Point2d shift_b = Point2d());

    const char* name() const override { return "points"; }
    double evaluate(const State& state) const override;
    double linearize(const State& state, NormalEquations& equations) override;

    void setLoss(const RobustLoss& loss) { loss_ = loss; }

    /// Distance of every match at present, canvas px, in the order given; infinite for one outside its image or
    /// without a finite weight of 0 or more.
    std::vector<double> distances(const State& state) const;

private:
    struct Pair
    {
        CellPoint a;
        CellPoint b;
        double weight;
    };
    Point2d residual(const Pair& pair, const State& state) const;

    int image_a_;
    int image_b_;
    RobustLoss loss_;
    Point2d shift_b_;
    std::vector<Pair> pairs_; ///< cell -1: left out
};

} // namespace gcpw
} // namespace cv

#endif
