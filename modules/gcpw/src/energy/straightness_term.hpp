// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#ifndef OPENCV_GCPW_STRAIGHTNESS_TERM_HPP
#define OPENCV_GCPW_STRAIGHTNESS_TERM_HPP

#include <vector>
#include "energy/energy_term.hpp"
#include "geometry/curve.hpp"

namespace cv
{
namespace gcpw
{

/** @brief Keeps as straight as the rough alignment has it what is straight in the scene. Not in the paper.

    E_b = weight * sum_m min over (alpha, beta) of sum_k ( n_mk . (W(s_mk) - R(s_mk)) - alpha - beta t_mk )^2

s_mk are points every `step` px along curve m, R their place in the rough alignment, n_mk and t_mk the normal and the arc length
there. A curve that only shifts, turns or moves along itself costs nothing, for any rough alignment, whether a homography leaves
lines straight or a sphere bends them. Residuals: 1 per sample, canvas px. */
class StraightnessTerm : public EnergyTerm
{
public:
    /// @param curves reference px of the image  @param step_px between samples, > 0
    StraightnessTerm(int image, const MeshGrid& rough, const std::vector<Curve>& curves, double step_px, double weight);

    const char* name() const override { return "straightness"; }
    double evaluate(const State& state) const override;
    double linearize(const State& state, NormalEquations& equations) override;

private:
    struct Sample
    {
        CellPoint point;
        Point2d rough;
        Point2d normal; ///< of the rough curve
    };
    struct Samples
    {
        std::vector<Sample> points;
        RowGroup rows; ///< of the points; they share the curve's offset and turn
    };
    /// Fills what offset and turn do not follow, one for each point; returns its sum of squares.
    double residuals(const Samples& curve, const State& state, std::vector<double>& result) const;

    int image_;
    double weight_;
    std::vector<Samples> curves_;
};

} // namespace gcpw
} // namespace cv

#endif
