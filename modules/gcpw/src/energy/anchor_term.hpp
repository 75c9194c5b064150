// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#ifndef OPENCV_GCPW_ANCHOR_TERM_HPP
#define OPENCV_GCPW_ANCHOR_TERM_HPP

#include <vector>
#include "energy/energy_term.hpp"

namespace cv
{
namespace gcpw
{

/** @brief Keeps chosen quads of an image near where another mesh has them.

    E_a = weight * sum_{anchored quads} sum_{k = 0..3} | V_k - A_k |^2

A_k are the corners of the quad in the other mesh. Not in the paper: for the regions where pixels made the alignment
worse, and as the shape prior of many images (Params::restWeight). Residuals: 8 per quad, canvas px. */
class AnchorTerm : public EnergyTerm
{
public:
    /// @param name of the energy in reports
    AnchorTerm(int image, const MeshGrid& anchor, const std::vector<int>& cells, double weight, const char* name = "anchors");

    const char* name() const override { return name_; }
    double evaluate(const State& state) const override;
    double linearize(const State& state, NormalEquations& equations) override;

private:
    int image_;
    MeshGrid anchor_;
    std::vector<int> cells_;
    double weight_;
    const char* name_;
};

} // namespace gcpw
} // namespace cv

#endif
