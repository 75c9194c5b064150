// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#ifndef GCPW_APPS_READ_PHOTOGRAPH_HPP
#define GCPW_APPS_READ_PHOTOGRAPH_HPP

#include <string>
#include <opencv2/core.hpp>
#include "common/metadata.hpp"

/// A photograph as its file has it, upright.
struct Photograph
{
    std::string path;
    cv::Mat image; ///< 8 or 16 bits: BGR, or BGRA where some pixels are not to be shown
    Metadata metadata;
    double scale = 1;   ///< pixels of the image per pixel of the file: less where only a reduced copy is kept
    cv::Size file_size; ///< of the picture in the file, upright; empty: the image's

    cv::Size size() const { return file_size.empty() ? image.size() : file_size; }
};

/** @brief Reads a photograph with its orientation, transparency and metadata.
@throws FileTrouble that names the file and says what is wrong: it is not there, no picture, of a kind that is not taken, cut short */
Photograph readPhotograph(const std::string& path);

/// Its pixels alone.
cv::Mat readImage(const std::string& path);

/// 8 bits a channel of a picture of 8 or 16.
cv::Mat toBytes(const cv::Mat& image);

/// Which pixels of BGRA are to be shown, CV_8UC1 of 0 and 255; empty for other pictures.
cv::Mat shownPixels(const cv::Mat& image);

/// BGR of BGRA.
cv::Mat withoutAlpha(const cv::Mat& image);

#endif
