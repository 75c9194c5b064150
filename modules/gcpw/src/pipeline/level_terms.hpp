// Part of the GCPW module for OpenCV. Licence: Apache-2.0 (see LICENSE).
#ifndef OPENCV_GCPW_LEVEL_TERMS_HPP
#define OPENCV_GCPW_LEVEL_TERMS_HPP

#include <vector>
#include "energy/block_buffer.hpp"
#include "opencv2/gcpw/alignment.hpp"
#include "pipeline/problem.hpp"
#include "pipeline/recipe.hpp"
#include "terms/anchor_term.hpp"
#include "terms/line_term.hpp"
#include "terms/photometric_term.hpp"
#include "terms/point_term.hpp"

namespace cv
{
namespace gcpw
{

/** @brief The data terms of a recipe on one pyramid level: everything that ties images together.

Regularisers (similarity, colour smoothness) do not change from level to level and stay with the optimiser. */
class LevelTerms
{
public:
    /// The geometric terms alone.
    LevelTerms(const Problem& problem, const Recipe& recipe, const Params& params);

    /// Puts the photometric terms of a level (0 is the finest) in the place of the former level's.
    void enterLevel(int level);

    /// Working pixels per pixel of the level.
    double scale() const { return scale_; }
    const std::vector<PhotometricTerm>& pixels() const { return pixels_; }

    /// Geman-McClure scale of the matches, canvas px; 0 is the plain sum of squares.
    void setMatchScale(double scale_px);

    /// Quads of an image that follow `anchor` from now on; their samples no longer move the mesh.
    void anchor(size_t pixel_term, const MeshGrid& mesh, const std::vector<int>& cells);

    /** @brief Pours all terms and adds their energies. Threads share the work; the sums do not depend on how many.

    What photometric terms fix (ColorTrust) holds for the steps from `states` once fix() is called.
    @param compare whether the function fixed before is evaluated too
    @return of the photometric terms: their samples' energy (as in `energies`), and of the functions fixed here and before */
    PhotometricTerm::Energy pour(const std::vector<ImageState>& states, bool compare, ResidualSink& sink, TermEnergies& energies);

    /// Takes what the last pour() fixed at `states` for the function to be minimised.
    void fix(const std::vector<ImageState>& states);

private:
    /// A part of a photometric term that one thread pours.
    struct Share
    {
        size_t term;
        Range cells;
    };
    PhotometricTerm::Energy pourPixels(const std::vector<ImageState>& states, bool compare, ResidualSink& sink);

    const Problem& problem_;
    Recipe recipe_;
    Params params_;
    double scale_ = 1;
    RobustLoss match_loss_;
    RobustLoss pixel_loss_;
    std::vector<PointTerm> points_;
    std::vector<LineTerm> lines_;
    std::vector<PhotometricTerm> pixels_;
    std::vector<AnchorTerm> anchors_;
    std::vector<AnchorTerm> rests_; ///< Params::restWeight; none in a pair
    std::vector<Share> shares_;
    std::vector<BlockBuffer> buffers_; ///< of the shares that are poured together
    std::vector<ImageState> fixed_states_;
    std::vector<std::vector<ColorTrust>> fixed_; ///< by pixel term and cell, at fixed_states_
    std::vector<std::vector<ColorTrust>> poured_; ///< of the last pour()
};

} // namespace gcpw
} // namespace cv

#endif
