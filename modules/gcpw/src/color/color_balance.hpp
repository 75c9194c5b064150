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

/** @brief The colours to be shown: overlapping quads agree in mean and contrast, and photographs keep their light; meshes stand still.

Least squares of pixels takes contrast from whatever differs. Means and contrasts do not: over all quads s and t that overlap, with
n samples, means m and standard deviations d,

With a reference, the others take its light:

    E = lambda_1 sum n a ( (G_s m_s + B_s - G_t m_t - B_t)^2 + d_s d_t log(G_s d_s / (G_t d_t))^2 )
        + smoothness (eq. colorterm)
        + Params::balanceWeight n_0 sum |(G, B) - exposure|^2

with n_0 the samples of a whole quad, and exposure of the image from estimateExposures().
a is re-weighted: agreementOf() the means of the two quads, less for Cr and Cb; quads without an overlap hold to the exposure with a
fifth of the weight. Clipped pixels count by their means alone. A gray photograph is compared in Y only.

Without one no image is privileged, and each keeps its black, its contrast and most of its hue. The logarithms are left out and

    E_k = Params::balanceWeight n_0 sum 2 (G - g)^2 + 30 B^2  in Y,  30 (G - g)^2 + 10 (G / 2 + B - g / 2 - b)^2  in Cr and Cb

takes the place of the last sum, with (g, b) from sharedLights(): a quad of Y has hardly more than a gain, and a hue is shifted, where
overlaps ask for it, no more than smoothly.

Then limitTones(): as a term of the sum, limits would only hold as far as the comparisons let them.
Without a reference no image is privileged: images that overlap, directly or by others, together keep the mean Y, Cr and Cb of
their photographs.
@param images finest level of each, whole photographs  @param overlaps whose samples are compared
@param state whose colours are ignored  @param reference the image that keeps its colours; negative: none
@return one grid an image; the identity without overlaps, the exposures, or the last pass that had one, where the system has no answer */
std::vector<ColorGrid> balancedColors(const std::vector<PyramidLevel>& images, const std::vector<OverlapSamples>& overlaps,
                                      const State& state, int reference, const Params& params);

} // namespace gcpw
} // namespace cv

#endif
