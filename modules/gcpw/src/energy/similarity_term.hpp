// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#ifndef OPENCV_GCPW_SIMILARITY_TERM_HPP
#define OPENCV_GCPW_SIMILARITY_TERM_HPP

#include <vector>
#include "energy/energy_term.hpp"

namespace cv
{
namespace gcpw
{

/** @brief Lets every triangle of the mesh change only by a similarity (eq. st1, similarityterm).

    E_s = weight * sum_i | V_1 - (V_2 + u (V_3 - V_2) + v R90 (V_3 - V_2)) |^2

Two triangles a quad, v1 v2 v3 and v4 v3 v2; (u, v) are the coordinates of the first vertex in the frame of the other
two in the *rough* mesh. Invariant to any similarity of the whole mesh.

With a stretch limit L (not in the paper) a quad of energy e and area A in the rough mesh counts e (1 + e / (2 A L^2)): a quad that is
stretched by the factor 1 + L, where e is about A L^2, resists twice as much to more of it, so that parallax is spread over many
quads rather than shear a few. */
class SimilarityTerm : public EnergyTerm
{
public:
    /// @param stretch_limit L; 0: none
    SimilarityTerm(int image, const MeshGrid& rough, double weight, double stretch_limit = 0);

    const char* name() const override { return "similarity"; }
    double evaluate(const State& state) const override;
    double linearize(const State& state, NormalEquations& equations) override;

private:
    int image_;
    std::vector<QuadBlock> blocks_; ///< full, symmetric
    std::vector<double> growth_;    ///< 1 / (weight A L^2) of every quad; 0 without a limit
};

/// The block of one quad over its corners, both triangles, weight 1; full, symmetric.
QuadBlock similarityBlock(const MeshGrid& rough, int cell);

} // namespace gcpw
} // namespace cv

#endif
