// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#ifndef GCPW_EVALUATION_SEAM_VISIBILITY_HPP
#define GCPW_EVALUATION_SEAM_VISIBILITY_HPP

#include "evaluation/cut.hpp"

namespace evaluation
{

/// How visible the cuts between the images of a picture are; lower is better, 0 cannot be seen. NaN where nothing is cut.
struct SeamVisibility
{
    int pixels = 0;           ///< length of all cuts
    double structure_p95 = 0; ///< of (1 - zncc) / 2 of 15 x 15 px windows of both images, flat ones left out: broken edges
    double worst = 0;         ///< largest mean of it over a stretch of 1/20 of a cut: the one ugly place
    double gradient_p95 = 0;  ///< of |g1 - g2| / (|g1| + |g2| + 4), g the gradients of gray: steps across the cut
    double color_p95 = 0;     ///< of the difference of 15 x 15 means in the largest channel, gray levels: what a plain sky shows
    cv::Point worst_place;    ///< canvas pixels: the middle of the worst stretch
    cv::Point strongest_place; ///< the same where contrast counts: what one sees first
};

/** @brief Cuts a picture by OpenCV's graph cut, the same for every method, and looks along the cuts.

The colours that are shown are compared, where both images have content. The cut is found at 0.3 Mpx for the largest image. */
SeamVisibility seamVisibility(const std::vector<WarpedImage>& images);

/// The same along a cut that is known.
SeamVisibility seamVisibility(const std::vector<WarpedImage>& images, const Labels& labels);

} // namespace evaluation

#endif
