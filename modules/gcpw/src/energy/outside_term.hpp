// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#ifndef OPENCV_GCPW_OUTSIDE_TERM_HPP
#define OPENCV_GCPW_OUTSIDE_TERM_HPP

#include <vector>
#include "energy/energy_term.hpp"

namespace cv
{
namespace gcpw
{

/** @brief Keeps size, direction and shape of what no other image shows. Not in the paper.

    E_o = weight * sum over quads c of w_c * sum over the edges (i, j) of c of | (V_i - R_i) - (V_j - R_j) |^2

V are the vertices, R their places in the rough alignment. A quad may shift; it pays for any turn, zoom and shear, the more the
larger its w_c. A similarity term alone lets the far end of an image turn and grow with what parallax does to the overlap. */
class OutsideTerm : public EnergyTerm
{
public:
    /// @param cell_weights w_c, one for each quad, >= 0
    OutsideTerm(int image, const MeshGrid& rough, const std::vector<double>& cell_weights, double weight);

    const char* name() const override { return "outside"; }
    double evaluate(const State& state) const override;
    double linearize(const State& state, NormalEquations& equations) override;

private:
    struct Quad
    {
        int cell;
        QuadBlock block; ///< full, symmetric
    };
    /// Energy of a quad, and half its slope.
    double slope(const Quad& quad, const State& state, QuadRow& gradient) const;

    int image_;
    MeshGrid rough_;
    std::vector<Quad> quads_; ///< those that weigh anything
};

} // namespace gcpw
} // namespace cv

#endif
