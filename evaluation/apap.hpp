// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#ifndef GCPW_EVALUATION_APAP_HPP
#define GCPW_EVALUATION_APAP_HPP

#include <opencv2/gcpw/pair.hpp>

namespace evaluation
{

/// Constants of the moving DLT.
struct ApapOptions
{
    /// Width of the kernel as a share of the source's diagonal, > 0. The published 8 to 12 px belong to an implementation whose
    /// kernel falls with the distance, exp(-d / sigma^2); for the Gaussian 0.04 is the best of 0.01 to 0.1 on photographs.
    double sigma = 0.04;
    double gamma = 0.0025; //!< least weight of a match, 0..1: the warp far from all matches. The best of the published range
};

/** @brief As-projective-as-possible warp (Zaragoza et al. 2013): one homography for each vertex of the mesh.

The homography of a vertex v minimises sum_i w_i^2 |a_i h|^2 over the matches, where a_i are the two rows of the direct
linear transform of match i in normalised coordinates and
    w_i = max(exp(-|v - p_i|^2 / sigma^2), gamma).
There is no smoothness besides the kernel: quads may fold, and Report::folds counts them.
@param matches status OK; its points are used, lines are not
@param params of the mesh and the working resolution
@return as of cv::gcpw::alignPair; status ROUGH with fewer than four points
@throws cv::Exception if options are out of range, or as alignPair */
cv::gcpw::Alignment alignApap(cv::InputArray source, cv::InputArray target, const cv::gcpw::PairMatches& matches,
                              const cv::gcpw::Params& params, const ApapOptions& options = ApapOptions());

} // namespace evaluation

#endif
