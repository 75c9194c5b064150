// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#ifndef GCPW_EVALUATION_COLOR_REMAP_HPP
#define GCPW_EVALUATION_COLOR_REMAP_HPP

#include <array>
#include <opencv2/gcpw/pair.hpp>
#include "evaluation/monotone_spline.hpp"

namespace evaluation
{

/// One curve for each of B, G, R.
typedef std::array<MonotoneSpline, 3> ColorCurves;

/** @brief The curves that take the colours of one image to those of another (after the remapping optimisation of Yao et al. 2017).

In each channel the curve is fitted to the paired quantiles of both images: where the overlap shows the same things, equal
shares of its pixels are equally bright in either.
@param from, to CV_8UC3 BGR  @param from_mask, to_mask CV_8UC1 of their sizes, non-zero where pixels count
@return identities if no pixel counts */
ColorCurves fitColorCurves(const cv::Mat& from, const cv::Mat& from_mask, const cv::Mat& to, const cv::Mat& to_mask,
                           const SplineOptions& options = SplineOptions());

/// An image (CV_8UC3) with each channel mapped by its curve.
cv::Mat applyColorCurves(const cv::Mat& image, const ColorCurves& curves);

/** @brief The curves from the source to the target, by the overlap that the matches alone make (Method::DFW).
@param source, target as of cv::gcpw::alignPair
@return identities without an alignment */
ColorCurves overlapCurves(const cv::Mat& source, const cv::Mat& target, const cv::gcpw::PairMatches& matches,
                          const cv::gcpw::Params& params);

} // namespace evaluation

#endif
