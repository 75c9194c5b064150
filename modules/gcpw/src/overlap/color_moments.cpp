// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#include "overlap/color_moments.hpp"

#include <cmath>

namespace cv
{
namespace gcpw
{

namespace
{

const double MAX_GAIN = 3;
const double MIN_CORRELATION_WEIGHT = 0.01; ///< not 0, so that a colour without other data is still determined

} // namespace

double plausibleGain(double gain)
{
    return std::min(std::max(gain, 1 / MAX_GAIN), MAX_GAIN);
}

double correlationWeight(double source_variance, double target_variance, double correlation)
{
    if (std::min(source_variance, target_variance) < TEXTURE_VARIANCE)
        return 1;
    const double positive = std::max(correlation, 0.0);
    return std::max(positive * positive, MIN_CORRELATION_WEIGHT);
}

double correlationWeight(const ColorMoments& moments)
{
    const double source = moments.sourceVariance(0);
    const double target = moments.targetVariance(0);
    return correlationWeight(source, target, moments.covariance(0) / std::sqrt(source * target));
}

double likeness(const ColorMoments& moments)
{
    if (!(moments.samples() > 0))
        return MIN_CORRELATION_WEIGHT;
    const double source = moments.sourceVariance(0);
    const double target = moments.targetVariance(0);
    const double larger = std::max(source, target);
    const double texture = larger / (larger + TEXTURE_VARIANCE); // 0: both are flat
    const double noise = 0.25 * TEXTURE_VARIANCE;                // of a flat patch: its correlation tends to 0
    const double correlation = moments.covariance(0) / std::sqrt((source + noise) * (target + noise));
    const double positive = std::max(correlation, 0.0);
    return std::max(1 - texture + texture * positive * positive, MIN_CORRELATION_WEIGHT);
}

} // namespace gcpw
} // namespace cv
