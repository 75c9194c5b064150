// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#ifndef OPENCV_GCPW_SAMPLE_SUMS_HPP
#define OPENCV_GCPW_SAMPLE_SUMS_HPP

#include <array>
#include <vector>
#include "solver/normal_equations.hpp"
#include "model/color_grid.hpp"

namespace cv
{
namespace gcpw
{

/** @brief One photometric sample, linearised: residual_c = mine_c - theirs_c, each colour-corrected.

gradient: of the corrected target by the canvas position, per channel. */
struct LinearSample
{
    double residual[3];
    double gx[3];
    double gy[3];
    double mine[3];   ///< source intensities before correction
    double theirs[3]; ///< target intensities before correction
    double weight;    ///< of the squared residual
};

/** @brief The weights by which the samples of a quad count for its colour.

Chosen where they are linearised and frozen until the next linearisation, so that the step and its line search see one
function: with E the energy of the samples, c the colours and c_0 those of the linearisation,

    w E(c) + (1 - w) E(c_0) + sum_c support_c (G_c - wanted_c)^2 - 2 sum_other_quads sum_c missing_c G_c G'_c,   w = correlation_weight.

Its value, gradient and Hessian at the linearisation are what SampleSums and CrossSums make of E. */
struct FrozenWeights
{
    struct OtherQuad
    {
        int target_cell;
        std::array<double, 3> missing; ///< see CrossSums::reweightColors(); weight and correlation_weight included
    };
    double correlation_weight = 1;
    ColorGrid::Quad color;           ///< c_0
    std::array<double, 3> support{}; ///< weight and correlation_weight included
    std::array<double, 3> wanted{};  ///< gains
    std::vector<OtherQuad> other_quads;

    void clear()
    {
        correlation_weight = 1;
        support.fill(0);
        other_quads.clear(); // keeps its memory
    }

    /// All but the samples' own energy.
    double extras(const ColorGrid::Quad& now, const ColorGrid& target) const
    {
        double energy = 0;
        for (int c = 0; c < CHANNELS; ++c)
            energy += support[c] * (now[c].gain - wanted[c]) * (now[c].gain - wanted[c]);
        for (const OtherQuad& other_quad : other_quads)
            for (int c = 0; c < CHANNELS; ++c)
                energy -= 2 * other_quad.missing[c] * now[c].gain * target.quad(other_quad.target_cell)[c].gain;
        return energy;
    }
};

/** @brief Running sums over the samples of one quad, expanded into a PhotometricBlock at the end.

A sample acts on its quad only through its position, so sums of w_k w_m times a 2 x 2 matrix determine the
8 x 8 block: a third of the multiplications. */
class SampleSums
{
public:
    void add(const float* corner_weight, const LinearSample& s);
    int samples() const { return samples_; }

    /// The block of all samples, times `weight`.
    PhotometricBlock block(double weight) const;

    /** @brief Weights the colour part of a quad's block by how well its two images correlate there.

    Least squares makes the gain rho * sd(T) / sd(I): where the images are misaligned or show different things it
    falls towards zero, the texture fades, and with it the gradient that would align it. So the gain gets a prior,

        E_v = weight * support * sum_c (1 - rho_c^2) n var(I_c) (G_c - sd(T_c) / sd(I_c))^2

    and the colour part of the block, E_v included, is scaled by max(rho_Y, 0)^2: where the images do not correlate, the
    neighbouring quads determine the colour.
    @param now colours at which the samples were taken
    @param support 0 leaves out E_v
    @param block of these samples; receives E_v
    @param fixed receives the weights chosen */
    void reweightColors(const ColorGrid::Quad& now, double weight, double support, PhotometricBlock& block,
                        FrozenWeights& fixed) const;

private:
    double curvature_[10][3] = {}; ///< per pair of corners k <= m: sum w_k w_m (xx, xy, yy) of g g^T
    double corner_[4][14] = {};    ///< per corner: sum w_k (gx r, gy r), then per channel w_k (gx I, gx, gy I, gy)
    struct ChannelCorrelation
    {
        double variance = 0;        ///< of I
        double target_variance = 0; ///< of T, the corrected target
        double correlation = 0;
    };
    ChannelCorrelation channelCorrelation(int channel, double gain) const;

    double color_[3][6] = {}; ///< per channel: sum I I, I, 1, I r, r, r r
    int samples_ = 0;
};

/// The same for a moving target: sums over those samples of one quad that fall into one quad of the target.
class CrossSums
{
public:
    void add(const float* corner_weight, const double* target_weight, const LinearSample& s);
    CrossBlock block(double weight) const;

    /** @brief The same where the target's colour is unknown too.

    There least squares can lower the energy of any misalignment by removing contrast from both images. So these samples compare
    means and contrasts, n ((G m + B - G' m' - B')^2 + (G sd(I) - G' sd(I'))^2), which is least squares of samples that
    correlate fully: the covariance is replaced by sd(I) sd(I').
    @param correlation_weight factor on the colour parts, see SampleSums::reweightColors()
    @param own, other of these samples; both change
    @return n (sd(I) sd(I') - cov(I, I')), per channel, times weight and correlation_weight */
    std::array<double, 3> reweightColors(const ColorGrid::Quad& now, const ColorGrid::Quad& now_other, double weight,
                                         double correlation_weight, PhotometricBlock& own, CrossBlock& other) const;

private:
    double cross_[4][4][3] = {};   ///< sum w_k w'_m (xx, xy, yy)
    double curvature_[10][3] = {}; ///< sum w'_k w'_m (xx, xy, yy)
    double slope_[4][2] = {};      ///< sum w'_k (gx r, gy r)
    double color_[3][8] = {};      ///< per channel: I I', I, I', 1, I' I', I' r, r, I I
};

} // namespace gcpw
} // namespace cv

#endif
