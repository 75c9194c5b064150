// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#ifndef OPENCV_GCPW_COLOR_BALANCE_HPP
#define OPENCV_GCPW_COLOR_BALANCE_HPP

#include <vector>
#include "opencv2/gcpw/params.hpp"
#include "overlap/overlap_samples.hpp"

namespace cv
{
namespace gcpw
{

/** @brief Colours of many images that make overlapping quads agree in mean and contrast while the meshes stand still.

Least squares of pixels takes contrast from whatever differs; in a pair the fixed target prevents that, but many images that
show different people all fade together. Means and contrasts do not: over all quads s and t that overlap, with n samples,
means m and standard deviations d,

    E = lambda_1 sum n correlation_weight ( (G_s m_s + B_s - G_t m_t - B_t)^2 + d_s d_t log(G_s d_s / (G_t d_t))^2 )
        + smoothness (eq. colorterm)
        + Params::balanceWeight n_0 sum |(G, B) - exposure|^2

with n_0 the samples of a whole quad (correlationWeight(), estimateExposures()). No image is privileged, mean log gain is 0 and mean
bias 0, unless Params::referenceImage names one: that keeps its colours.
@param overlaps whose samples are compared  @param state whose colours are ignored
@return one grid an image; the identity without overlaps, the exposures, or the last pass that had one, where the system has no answer */
std::vector<ColorGrid> balancedColors(const std::vector<OverlapSamples>& overlaps, const State& state, const Params& params);

} // namespace gcpw
} // namespace cv

#endif
