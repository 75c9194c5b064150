// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#ifndef GCPW_EVALUATION_LOCALITY_SENSITIVE_HISTOGRAM_HPP
#define GCPW_EVALUATION_LOCALITY_SENSITIVE_HISTOGRAM_HPP

#include <opencv2/core.hpp>

namespace evaluation
{

/// Constants of the illumination-invariant image: the best of those tried on photographs, with a reach of 0.003 to 0.1, a
/// relative width of 0.1 to 0.8 and a narrowest of 1 or 2 bins. Alignment wants a shorter reach than tracking does.
struct LshOptions
{
    int bins = 32;         ///< of the histogram over 0..255, 2..256
    double reach = 0.005;  ///< distance at which a pixel counts 1/e, as a share of the image's diagonal, > 0
    double relative = 0.8; ///< width of the interval around a pixel's own intensity, as a share of that intensity, > 0
    double narrowest = 2;  ///< least width of that interval, bins, > 0
};

/** @brief Illumination-invariant image by locality-sensitive histograms (He et al. 2013).

The histogram of pixel p counts every pixel q of the image by its distance,
    H_p(b) = sum_q alpha^|p-q| [b_q = b] / sum_q alpha^|p-q|,   |p-q| along rows and columns,
by two recursive passes an axis. The value of p is the share of its surroundings that is about as bright as itself,
    sum_b exp(-(b - b_p)^2 / (2 max(narrowest, relative * b_p)^2)) H_p(b),
which a change of gain around p leaves alone. A pixel between two bins is shared by them.
@param image CV_8UC3 BGR or CV_8UC1
@return CV_8UC3 of its size, all channels alike: 255 times the value
@throws cv::Exception if the image is empty or of another type, or options are out of range */
cv::Mat invariantImage(const cv::Mat& image, const LshOptions& options = LshOptions());

} // namespace evaluation

#endif
