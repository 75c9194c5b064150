// Part of the GCPW module for OpenCV. Licence: Apache-2.0 (see LICENSE).
#ifndef OPENCV_GCPW_COLOR_BALANCE_HPP
#define OPENCV_GCPW_COLOR_BALANCE_HPP

#include <vector>
#include "opencv2/gcpw/params.hpp"
#include "terms/photometric_term.hpp"

namespace cv
{
namespace gcpw
{

/** @brief Colours of many images that make overlapping quads agree in mean and contrast while the meshes stand still.

Least squares of pixels takes contrast from whatever differs; in a pair the target holds against it, but many images that
show different people all fade together. Contrasts do not: over all quads s and t that lie on each other, with n samples,
means m and standard deviations d,

    E = lambda_1 sum n trust ( (G_s m_s + B_s - G_t m_t - B_t)^2 + d_s d_t log(G_s d_s / (G_t d_t))^2 )
        + smoothness (eq. colorterm)
        + Params::balanceWeight n_0 sum |(G, B) - exposure|^2

with n_0 the samples of a whole quad (trustIn(), estimateExposures()). No image is privileged, mean log gain is 0 and mean
bias 0, unless Params::referenceImage names one: that keeps its colours.
@param terms whose samples are compared  @param states whose colours are ignored
@return one grid an image; the identity without terms, the exposures, or the last pass that had one, where the system has no answer */
std::vector<ColorGrid> balancedColors(const std::vector<PhotometricTerm>& terms, const std::vector<ImageState>& states,
                                      const Params& params);

} // namespace gcpw
} // namespace cv

#endif
