// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#ifndef OPENCV_GCPW_COLOR_MOMENTS_HPP
#define OPENCV_GCPW_COLOR_MOMENTS_HPP

#include <algorithm>
#include "model/color_grid.hpp"

namespace cv
{
namespace gcpw
{

const double TEXTURE_VARIANCE = 2.5e-4; ///< of Y (16 gray levels squared): correlation of less is noise

/// Sums over pairs of intensities (a of the source, b of the target).
struct PairSums
{
    double n = 0, a = 0, b = 0, aa = 0, bb = 0, ab = 0;

    void add(double p, double q)
    {
        n += 1;
        a += p;
        b += q;
        aa += p * p;
        bb += q * q;
        ab += p * q;
    }

    /// The other's pairs, each counting `weight`.
    void add(const PairSums& other, double weight)
    {
        n += weight * other.n;
        a += weight * other.a;
        b += weight * other.b;
        aa += weight * other.aa;
        bb += weight * other.bb;
        ab += weight * other.ab;
    }
};

/// Means, variances and covariance of pairs of colours, Y, Cr and Cb in [0, 1].
class ColorMoments
{
public:
    void add(const float* source, const float* target)
    {
        for (int c = 0; c < CHANNELS; ++c)
            sums_[c].add(source[c], target[c]);
    }

    /// The other's samples, each counting `weight`.
    void add(const ColorMoments& other, double weight)
    {
        for (int c = 0; c < CHANNELS; ++c)
            sums_[c].add(other.sums_[c], weight);
    }

    double samples() const { return sums_[0].n; }
    double sourceMean(int c) const { return sums_[c].a / samples(); }
    double targetMean(int c) const { return sums_[c].b / samples(); }
    double sourceVariance(int c) const { return variance(sums_[c].aa, sums_[c].a); }
    double targetVariance(int c) const { return variance(sums_[c].bb, sums_[c].b); }
    double covariance(int c) const { return (sums_[c].ab - sums_[c].a * sums_[c].b / samples()) / samples(); }

private:
    double variance(double squares, double sum) const { return std::max((squares - sum * sum / samples()) / samples(), 0.0); }

    PairSums sums_[CHANNELS];
};

/// Clamps a gain to the range that occurs between two photographs of one scene.
double plausibleGain(double gain);

/** @brief How much an overlap counts for its colours: the squared correlation of the two images' luma, 0 if negative.

@return in (0, 1]; 1 where one of them is flat: there is no texture to compare, and the mean is as good as any */
double correlationWeight(double source_variance, double target_variance, double correlation);
double correlationWeight(const ColorMoments& moments);

/** @brief How much two patches count for the colours of whole images: correlationWeight(), but little where only one has texture.

A patch that is flat in one image and textured in the other shows two things. Continuous in the variances.
@return in (0, 1]; 1 where both are flat */
double likeness(const ColorMoments& moments);

} // namespace gcpw
} // namespace cv

#endif
