// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#ifndef GCPW_APPS_REPORT_MAPS_HPP
#define GCPW_APPS_REPORT_MAPS_HPP

#include "report/picture.hpp"

namespace report
{

/// Where photographs that overlap do not agree.
struct Misalignment
{
    /// CV_32FC1 as large as its frame: mean over all pairs of (1 - zncc) / 2; -1 where nothing can be compared
    cv::Mat unlikeness;
    double share = 0; ///< per cent of the pixels that can be compared where it is above DOUBLE; NaN if there are none
};

/// Unlikeness (1 - zncc) / 2 from which on a window looks double or broken: a correlation below 0.6.
const double DOUBLE = 0.2;

/// Of the photographs of a picture, over windows of evaluation::LIKENESS_WINDOW, in `frame`.
Misalignment misalignmentOf(const std::vector<evaluation::WarpedImage>& images, const cv::Rect& frame);

/// Misalignment over a gray picture of the frame: yellow from DOUBLE / 2 on, over red to violet for what has nothing in common.
cv::Mat drawn(const Misalignment& misalignment, const cv::Mat& picture);

/// Change of light in gray levels at which the colours of drawnLight() are strongest.
const double STRONG_LIGHT = 30;

/// What the colour correction does to the light of the photograph that is seen, over a gray picture of the frame: orange where it
/// is lighter, blue where it is darker.
cv::Mat drawnLight(const Picture& picture, const cv::Mat& framed_image, const cv::Rect& frame);

} // namespace report

#endif
