// Part of the GCPW module for OpenCV. Licence: Apache-2.0 (see LICENSE).
#ifndef OPENCV_GCPW_SAMPLE_SUMS_HPP
#define OPENCV_GCPW_SAMPLE_SUMS_HPP

#include <array>
#include <vector>
#include "energy/residual_sink.hpp"
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

/** @brief How far the samples of a quad are heard about its colour.

Chosen where they are linearised and fixed until the next linearisation, so that the step and its line search see one
function: with E the energy of the samples, c the colours and c_0 those of the linearisation,

    trust E(c) + (1 - trust) E(c_0) + sum_c support_c (G_c - wanted_c)^2 - 2 sum_partners sum_c missing_c G_c G'_c

Its value, gradient and Hessian at the linearisation are what SampleSums and PartnerSums make of E. */
struct ColorTrust
{
    struct Partner
    {
        int target_cell;
        std::array<double, 3> missing; ///< see PartnerSums::judgeColors(); weight and trust included
    };
    double trust = 1;
    std::array<double, 3> support{}; ///< weight and trust included
    std::array<double, 3> wanted{};  ///< gains
    std::vector<Partner> partners;

    void clear()
    {
        trust = 1;
        support.fill(0);
        partners.clear(); // keeps its memory
    }

    /// All but the samples' own energy.
    double extras(const ColorGrid::Quad& color, const ColorGrid& target) const
    {
        double energy = 0;
        for (int c = 0; c < CHANNELS; ++c)
            energy += support[c] * (color[c].gain - wanted[c]) * (color[c].gain - wanted[c]);
        for (const Partner& partner : partners)
            for (int c = 0; c < CHANNELS; ++c)
                energy -= 2 * partner.missing[c] * color[c].gain * target.quad(partner.target_cell)[c].gain;
        return energy;
    }
};

/** @brief Running sums over the samples of one quad, folded out into a ColoredBlock at the end.

A sample acts on its quad only through its position, so sums of w_k w_m times a 2 x 2 matrix say all that an 8 x 8 block
holds: a third of the multiplications. */
class SampleSums
{
public:
    void add(const float* corner_weight, const LinearSample& s);
    int samples() const { return samples_; }

    /// The block of all samples, times `weight`.
    ColoredBlock block(double weight) const;

    /** @brief Lets a quad speak of colour only as far as its two images show the same thing.

    Least squares makes the gain rho * sd(T) / sd(I): where the images do not line up or show different things it falls
    towards zero, the texture fades, and with it the force that would align it. So the gain is held up,

        E_v = weight * support * sum_c (1 - rho_c^2) n var(I_c) (G_c - sd(T_c) / sd(I_c))^2

    and all the quad says of its colour, E_v too, counts by max(rho_Y, 0)^2, so that its neighbours decide.
    @param now colours at which the samples were taken
    @param support 0 leaves out E_v
    @param block of these samples; receives E_v
    @param fixed receives the choice */
    void judgeColors(const ColorGrid::Quad& now, double weight, double support, ColoredBlock& block, ColorTrust& fixed) const;

private:
    double curvature_[10][3] = {}; ///< per pair of corners k <= m: sum w_k w_m (xx, xy, yy) of g g^T
    double corner_[4][14] = {};    ///< per corner: sum w_k (gx r, gy r), then per channel w_k (gx I, gx, gy I, gy)
    struct Likeness
    {
        double variance = 0;        ///< of I
        double target_variance = 0; ///< of T, the corrected target
        double correlation = 0;
    };
    Likeness likeness(int channel, double gain) const;

    double color_[3][6] = {};      ///< per channel: sum I I, I, 1, I r, r, r r
    int samples_ = 0;
};

/// The partner's sums: over those samples of one quad that fall into one quad of a moving target.
class PartnerSums
{
public:
    void add(const float* corner_weight, const double* partner_weight, const LinearSample& s);
    PartnerBlock block(double weight) const;

    /** @brief The same where the target's colour is unknown too.

    There least squares has a way out of every misalignment: to take contrast from both images. So these samples compare
    means and contrasts, n ((G m + B - G' m' - B')^2 + (G sd(I) - G' sd(I'))^2), which is least squares of samples that
    correlate fully: the covariance is replaced by sd(I) sd(I').
    @param trust factor on what is said of colour, SampleSums::judgeColors()
    @param own, other of these samples; both change
    @return what the covariance lacks, per channel, times weight and trust */
    std::array<double, 3> judgeColors(const ColorGrid::Quad& now, const ColorGrid::Quad& now_other, double weight, double trust,
                                      ColoredBlock& own, PartnerBlock& other) const;

private:
    double cross_[4][4][3] = {};   ///< sum w_k w'_m (xx, xy, yy)
    double curvature_[10][3] = {}; ///< sum w'_k w'_m (xx, xy, yy)
    double slope_[4][2] = {};      ///< sum w'_k (gx r, gy r)
    double color_[3][8] = {};      ///< per channel: I I', I, I', 1, I' I', I' r, r, I I
};

} // namespace gcpw
} // namespace cv

#endif
