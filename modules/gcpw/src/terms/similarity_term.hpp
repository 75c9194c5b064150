// Part of the GCPW module for OpenCV. Licence: Apache-2.0 (see LICENSE).
#ifndef OPENCV_GCPW_SIMILARITY_TERM_HPP
#define OPENCV_GCPW_SIMILARITY_TERM_HPP

#include <vector>
#include "energy/residual_sink.hpp"
#include "model/mesh_grid.hpp"

namespace cv
{
namespace gcpw
{

/** @brief Lets every triangle of the mesh change only by a similarity (eq. st1, similarityterm).

    E_s = weight * sum_i | V_1 - (V_2 + u (V_3 - V_2) + v R90 (V_3 - V_2)) |^2

Two triangles a quad, v1 v2 v3 and v4 v3 v2; (u, v) are the coordinates of the first vertex in the frame of the other
two in the *rough* mesh. Quadratic, so each quad's block is made once. Invariant to any similarity of the whole mesh.
Quads that would fold are damped (stiffen()): a step then costs the energy of its *change* as well, which shortens it
there and leaves energy and gradient alone. */
class SimilarityTerm
{
public:
    SimilarityTerm(int image, const MeshGrid& rough, double weight);

    double linearize(const MeshGrid& mesh, ResidualSink& sink) const;

    double energy(const MeshGrid& mesh) const;

    /// Ends all damping.
    void relax();

    /// Multiplies the block by which a quad resists a step, up to a limit, and pours what that adds.
    void stiffen(int cell, double factor, ResidualSink& sink);

private:
    struct Stiff
    {
        QuadBlock block; ///< full, symmetric
        double factor = 1; ///< on the block of a step
    };
    /// Gradient and energy of a quad.
    double slope(int cell, const MeshGrid& mesh, QuadRow& gradient) const;

    int image_;
    std::vector<Stiff> quads_;
};

} // namespace gcpw
} // namespace cv

#endif
