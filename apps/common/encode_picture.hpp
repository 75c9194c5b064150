// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#ifndef GCPW_APPS_ENCODE_PICTURE_HPP
#define GCPW_APPS_ENCODE_PICTURE_HPP

#include <string>
#include <vector>
#include <opencv2/core.hpp>
#include "common/metadata.hpp"

class CommandLine;

/// How pictures are written.
struct PictureFormat
{
    int quality = 95;                ///< of JPEG and WebP, 1 to 100
    std::string compression = "lzw"; ///< of TIFF: none, lzw, deflate
};

/// Declares the options of a format.
void declareFormat(CommandLine& line, PictureFormat& format);

/** @brief Writes a picture as the ending of its name says, with the metadata of its photographs.

To PNG and TIFF with the bits that it has; all others take 8. To a name without an ending, such as a pipe's, as PNG.
@param picture 8 or 16 bits, BGR
@throws FileTrouble */
void writePicture(const std::string& path, const cv::Mat& picture, const PictureFormat& format,
                  const Metadata& metadata);

/// Whether a picture of this name keeps 16 bits.
bool keepsDeepPixels(const std::string& path);

#endif
