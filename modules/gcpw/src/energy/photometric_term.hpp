// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#ifndef OPENCV_GCPW_PHOTOMETRIC_TERM_HPP
#define OPENCV_GCPW_PHOTOMETRIC_TERM_HPP

#include <vector>
#include "energy/energy_term.hpp"
#include "energy/sample_sums.hpp"
#include "overlap/overlap_samples.hpp"
#include "solver/robust_loss.hpp"

namespace cv
{
namespace gcpw
{

/** @brief Makes a sample of the source image look like the target at its warped position (eq. photoerror2, phototerm).

    E_p = weight * sum_q rho( w_q sum_c ((G_c I_s,c(q) + B_c) - (G'_c I_t,c(p) + B'_c))^2 ),   p = W_t^-1( W_s(q) )

q are the samples of an overlap, w_q their importance, I in [0, 1]. The target's colour (G', B') is the identity in the
two-image case. In the paper rho(s) = s and w_q = 1. Samples whose p leaves the target do not count. With gain_support > 0 the
value that is compared is the one whose weights were frozen at the last linearize(): see FrozenWeights. */
class PhotometricTerm : public EnergyTerm
{
public:
    struct Options
    {
        double weight = 100;       ///< lambda_1
        double gain_support = 0;   ///< see SampleSums::reweightColors(); 0 in the paper
        bool target_moves = false; ///< whether mesh or colour of the target are unknowns too
        RobustLoss loss;
    };

    /** @param samples must outlive the term
    @param frozen_cells quads of the source whose samples may not move a mesh; they inform the colours only */
    PhotometricTerm(const OverlapSamples& samples, const Options& options, const std::vector<int>& frozen_cells = std::vector<int>());

    const char* name() const override { return "photometric"; }
    double evaluate(const State& state) const override;
    /// One PhotometricBlock a quad with samples and, if the target moves, its CrossBlocks.
    double linearize(const State& state, NormalEquations& equations) override;

    /// A few rows of quads each.
    int parts() const override;
    double evaluatePart(const State& state, int part) const override;
    double linearizePart(const State& state, int part, NormalEquations& equations) override;

private:
    Range cellsOf(int part) const;
    double evaluateCells(const State& state, Range cells) const;
    double linearizeCells(const State& state, Range cells, NormalEquations& equations);
    void addQuad(const State& state, int cell, const SampleSums& sums, const std::vector<std::pair<int, CrossSums>>& cross,
                 PhotometricBlock& block, NormalEquations& equations);

    const OverlapSamples& samples_;
    Options options_;
    std::vector<bool> mesh_frozen_;      ///< by cell
    std::vector<FrozenWeights> weights_; ///< by cell
    ColorGrid target_color_;             ///< at the last linearisation
};

} // namespace gcpw
} // namespace cv

#endif
