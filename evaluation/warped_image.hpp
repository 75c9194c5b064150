// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#ifndef GCPW_EVALUATION_WARPED_IMAGE_HPP
#define GCPW_EVALUATION_WARPED_IMAGE_HPP

#include <string>
#include <vector>
#include <opencv2/gcpw/pair.hpp>

namespace evaluation
{

/// One warped photograph on a canvas.
struct WarpedImage
{
    cv::Rect place;    ///< canvas pixels
    cv::Mat image;     ///< CV_8UC3, colours untouched
    cv::Mat corrected; ///< CV_8UC3, its colours as they are shown
    cv::Mat mask;      ///< CV_8UC1, 255 or 0
    bool fixed = false; ///< the target of a pair, whose colours stay
};

/// The smallest rectangle of the canvas that holds all images; there must be one.
cv::Rect canvasOf(const std::vector<WarpedImage>& images);

/** @brief What gcpw_stitch --dump has written.
@param folder see scoreDump()
@throws cv::Exception that names the file if one is missing or does not fit */
std::vector<WarpedImage> readDump(const std::string& folder);

/// Source and target of a pair.
std::vector<WarpedImage> imagesOf(const cv::gcpw::PairCanvas& canvas);

} // namespace evaluation

#endif
