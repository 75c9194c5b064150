// Part of the GCPW module for OpenCV. Licence: Apache-2.0 (see LICENSE).
#ifndef OPENCV_GCPW_COLOR_MOMENTS_HPP
#define OPENCV_GCPW_COLOR_MOMENTS_HPP

#include <algorithm>
#include "model/color_grid.hpp"

namespace cv
{
namespace gcpw
{

/// Sums over pairs of intensities (I of the source, T of the target), Y, Cr and Cb in [0, 1].
class ColorMoments
{
public:
    template <typename Value>
    void add(const float* source, const Value* target)
    {
        ++samples_;
        for (int c = 0; c < CHANNELS; ++c)
        {
            const double i = source[c];
            const double t = target[c];
            Sums& s = sums_[c];
            s.i += i;
            s.t += t;
            s.ii += i * i;
            s.tt += t * t;
            s.it += i * t;
        }
    }

    /// The other's samples, each counting `weight`.
    void add(const ColorMoments& other, double weight = 1)
    {
        samples_ += weight * other.samples_;
        for (int c = 0; c < CHANNELS; ++c)
        {
            sums_[c].i += weight * other.sums_[c].i;
            sums_[c].t += weight * other.sums_[c].t;
            sums_[c].ii += weight * other.sums_[c].ii;
            sums_[c].tt += weight * other.sums_[c].tt;
            sums_[c].it += weight * other.sums_[c].it;
        }
    }

    double samples() const { return samples_; }
    double sourceMean(int c) const { return sums_[c].i / samples_; }
    double targetMean(int c) const { return sums_[c].t / samples_; }
    double sourceVariance(int c) const { return variance(sums_[c].ii, sums_[c].i); }
    double targetVariance(int c) const { return variance(sums_[c].tt, sums_[c].t); }
    double covariance(int c) const { return (sums_[c].it - sums_[c].i * sums_[c].t / samples_) / samples_; }

private:
    struct Sums
    {
        double i = 0, t = 0, ii = 0, tt = 0, it = 0;
    };

    double variance(double squares, double sum) const { return std::max((squares - sum * sum / samples_) / samples_, 0.0); }

    double samples_ = 0;
    Sums sums_[CHANNELS];
};

/** @brief How far two images can be believed to show the same thing: the squared correlation of their luma.

@return in (0, 1]; 1 where one of them is flat, as then its mean is worth as much as any */
double trustIn(const ColorMoments& moments);

} // namespace gcpw
} // namespace cv

#endif
