// Part of the GCPW module for OpenCV. Licence: Apache-2.0 (see LICENSE).
#ifndef OPENCV_GCPW_PHOTOMETRIC_TERM_HPP
#define OPENCV_GCPW_PHOTOMETRIC_TERM_HPP

#include <vector>
#include "energy/residual_sink.hpp"
#include "energy/robust_loss.hpp"
#include "imaging/sampler.hpp"
#include "model/image_state.hpp"
#include "terms/color_moments.hpp"
#include "terms/sample_sums.hpp"
#include "terms/target_lookup.hpp"

namespace cv
{
namespace gcpw
{

/** @brief Makes a sample of the source image look like the target at its warped position (eq. photoerror2, phototerm).

    E_p = weight * sum_q rho( w_q sum_c ((G_c I_s,c(q) + B_c) - (G'_c I_t,c(p) + B'_c))^2 ),   p = W_t^-1( W_s(q) )

q are material points: every `step`-th pixel of the source level, fixed in their rest quads, so that weights and sparsity
never change; I in [0, 1]. The target's colour (G', B') is the identity in the two-image case. In the paper rho(s) = s and
w_q = 1; see Options. Samples whose p leaves the target do not count. */
class PhotometricTerm
{
public:
    struct Options
    {
        int step = 3;              ///< px of the level between samples
        double weight = 100;       ///< lambda_1
        double gain_support = 0;   ///< see SampleSums::judgeColors(); 0 in the paper
        double contrast_floor = 0; ///< f > 0: w_q = 0.01 / (v + f^2) with v the variance of Y in 5 x 5 px; 0: w_q = 1
    };

    PhotometricTerm() = default; ///< of no samples

    /** @param source_image, target_image indices for the sink
    @param source, target levels of equal scale  @param lattice of the source
    @param target_shift canvas px by which the target is seen beside its own place (a canvas that wraps around) */
    PhotometricTerm(int source_image, int target_image, const PyramidLevel& source, const PyramidLevel& target,
                    const Lattice& lattice, const Options& options, Point2d target_shift = Point2d());

    int sourceImage() const { return source_image_; }
    int targetImage() const { return target_image_; }

    /// The function that a linearisation fixed (see ColorTrust).
    struct Fixed
    {
        const std::vector<ImageState>& images;  ///< at which it was linearised
        const std::vector<ColorTrust>& weights; ///< by cell
    };

    struct Energy
    {
        double samples = 0; ///< E_p
        double here = 0;    ///< of the function that is fixed here
        double fixed = 0;   ///< of the function that was fixed before
    };

    /** @brief Pours one ColoredBlock per quad with samples and, if the target moves, its PartnerBlocks.
    @param cells quads of the source to pour; several threads may share a term
    @param before the function to evaluate beside, or null
    @param weights by cell; receives the function that is fixed here, for the cells poured */
    Energy linearize(const std::vector<ImageState>& images, bool target_moves, const RobustLoss& loss, Range cells,
                     ResidualSink& sink, const Fixed* before, std::vector<ColorTrust>& weights) const;

    /// The same for its energy `here` alone.
    double linearize(const std::vector<ImageState>& images, bool target_moves, const RobustLoss& loss, Range cells,
                     ResidualSink& sink) const
    {
        std::vector<ColorTrust> weights(lattice_.cellCount());
        return linearize(images, target_moves, loss, cells, sink, nullptr, weights).here;
    }
    /// All quads.
    double linearize(const std::vector<ImageState>& images, bool target_moves, const RobustLoss& loss,
                     ResidualSink& sink) const
    {
        return linearize(images, target_moves, loss, Range(0, lattice_.cellCount()), sink);
    }

    /// How little the two images correlate in a quad.
    struct QuadMiss
    {
        double sum = 0;  ///< of (1 - correlation)^2 over the textured quarters of the quad, times their samples
        int samples = 0;
    };
    std::vector<QuadMiss> correlate(const std::vector<ImageState>& images) const;

    /// What the two images show where a quad of the source lies on a quad of the target, before any correction.
    struct QuadColors
    {
        int source_cell = -1;
        int target_cell = -1;
        ColorMoments moments;
    };
    /// In the order of the source's quads.
    std::vector<QuadColors> compareColors(const std::vector<ImageState>& images) const;

    /// Quads whose samples may no longer move a mesh; they go on informing the colours.
    void freeze(const std::vector<int>& cells);

private:
    struct Sample
    {
        float weight[4];  ///< bilinear
        float value[3];   ///< Y, Cr, Cb
        float importance; ///< w_q
    };

    /// Calls visit(sample, pixel, residual[3], squared residual times w_q) for the samples of a quad that are inside.
    template <typename Visit>
    void forEachInside(const std::vector<ImageState>& images, int cell, TargetLookup& target, Visit visit) const;

    int source_image_ = -1;
    int target_image_ = -1;
    PyramidLevel target_;
    Lattice lattice_;
    Options options_;
    Point2d target_shift_;
    std::vector<Sample> samples_; ///< sorted by cell
    std::vector<int> first_;      ///< first sample of every cell, and one past the last
    std::vector<bool> frozen_;    ///< by cell
};

} // namespace gcpw
} // namespace cv

#endif
