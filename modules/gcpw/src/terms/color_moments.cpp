// Part of the GCPW module for OpenCV. Licence: Apache-2.0 (see LICENSE).
#include "terms/color_moments.hpp"

#include <cmath>

namespace cv
{
namespace gcpw
{

namespace
{

const double TEXTURE_VARIANCE = 2.5e-4; ///< of Y (16 gray levels squared): below, correlation says nothing
const double MIN_TRUST = 0.01;          ///< keeps a colour that nothing else informs

} // namespace

double trustIn(const ColorMoments& moments)
{
    const double source = moments.sourceVariance(0);
    const double target = moments.targetVariance(0);
    if (std::min(source, target) < TEXTURE_VARIANCE)
        return 1;
    const double correlation = std::max(moments.covariance(0), 0.0) / std::sqrt(source * target);
    return std::max(correlation * correlation, MIN_TRUST);
}

} // namespace gcpw
} // namespace cv
