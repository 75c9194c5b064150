// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#ifndef GCPW_EVALUATION_LIKENESS_HPP
#define GCPW_EVALUATION_LIKENESS_HPP

#include "evaluation/warped_image.hpp"

namespace evaluation
{

const int LIKENESS_WINDOW = 15; ///< px, side of the windows that are compared

/// Two images where they share a rectangle of the canvas.
struct Shared
{
    cv::Rect box; ///< canvas pixels
    cv::Mat a;    ///< CV_8UC3, its colours as they are shown
    cv::Mat b;
    cv::Mat both; ///< CV_8UC1, 255 where both have whole windows; empty if they share too little
};

Shared sharedPart(const WarpedImage& a, const WarpedImage& b);

/// What windows around each pixel of two images have in common.
struct Likeness
{
    cv::Mat structure; ///< CV_64FC1, (1 - zncc) / 2 of both windows, 0 alike to 1 inverted; -1 where a window is flat
    cv::Mat contrast;  ///< CV_64FC1, geometric mean of both windows' deviations, gray levels; 0 where one is flat
};

/// @param a, b CV_64FC1, gray levels, of one size
Likeness likenessOf(const cv::Mat& a, const cv::Mat& b);

/// Mean over the windows, of any number of channels.
cv::Mat windowMean(const cv::Mat& image);

/// A BGR image (CV_8UC3) as CV_64FC1 gray levels.
cv::Mat grayOf(const cv::Mat& bgr);

} // namespace evaluation

#endif
