// Part of the GCPW module for OpenCV. Licence: Apache-2.0 (see LICENSE).
#ifndef OPENCV_GCPW_PHOTOMETRIC_TERM_HPP
#define OPENCV_GCPW_PHOTOMETRIC_TERM_HPP

#include <vector>
#include "energy/residual_sink.hpp"
#include "energy/robust_loss.hpp"
#include "imaging/sampler.hpp"
#include "model/color_grid.hpp"
#include "model/mesh_grid.hpp"

namespace cv
{
namespace gcpw
{

/** @brief Where an image lies at the moment: its mesh and its colour. */
struct ImageState
{
    MeshGrid mesh;
    ColorGrid color;
};

/** @brief Makes a sample of the source image look like the target at its warped position (eq. photoerror2, phototerm).

    E_p = weight * sum_q w_q sum_c rho( (G_c I_s,c(q) + B_c) - (G'_c I_t,c(p) + B'_c) ),   p = W_t^-1( W_s(q) )

q are material points: every `step`-th pixel of the source level, fixed in their rest quads; I in [0, 1]. The target's
colour (G', B') is the identity in the two-image case. rho is applied to the sum over channels. Samples whose p leaves
the target count with the mean energy they had when the term was made, so that leaving the overlap never pays.
w_q evens out contrast (see Options); 1 in the paper. */
class PhotometricTerm
{
public:
    struct Options
    {
        int step = 3;              ///< px of the level between samples
        double weight = 100;       ///< lambda_1
        double contrast_floor = 0; ///< if > 0: w_q = mean(v) / v with v = local variance of Y + floor^2; 0: w_q = 1
    };

    /** @param source_image, target_image indices for the sink
    @param source, target levels of equal scale  @param lattice of the source */
    PhotometricTerm(int source_image, int target_image, const PyramidLevel& source, const PyramidLevel& target,
                    const Lattice& lattice, const Options& options);

    int sourceImage() const { return source_image_; }
    int targetImage() const { return target_image_; }

    /** @brief Pours one ColoredBlock per quad with samples (and cross blocks if the target moves).
    @param loss of a sample's squared residual, sum over channels
    @return the robust energy */
    double linearize(const std::vector<ImageState>& images, bool target_moves, const RobustLoss& loss,
                     ResidualSink& sink) const;

    /// Squared residuals (sum over channels, times w_q) of the samples that are inside the target now.
    std::vector<float> squaredResiduals(const std::vector<ImageState>& images) const;

    /// Number of samples inside the target for every quad of the source.
    std::vector<int> countInside(const std::vector<ImageState>& images) const;

private:
    struct Sample
    {
        float weight[4];
        float value[3];
        float importance;
    };
    class Target;

    /// Calls visit(sample, pixel, residual[3], squared residual times w_q) for the samples of a quad that are inside.
    template <typename Visit>
    void forEachInside(const std::vector<ImageState>& images, int cell, Target& target, Visit visit) const;
    void setImportance(double contrast_floor);

    int source_image_;
    int target_image_;
    PyramidLevel source_;
    PyramidLevel target_;
    Lattice lattice_;
    Options options_;
    std::vector<Sample> samples_;
    std::vector<int> first_; ///< first sample of every cell, and one past the last
    std::vector<Point> pixels_;
};

} // namespace gcpw
} // namespace cv

#endif
