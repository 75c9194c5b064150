// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#ifndef GCPW_APPS_HEIF_HPP
#define GCPW_APPS_HEIF_HPP

#include <string>
#include <opencv2/core.hpp>

/// Whether a file is HEIF (.heic, .heif, .avif), by its first bytes.
bool isHeif(const std::string& path);

/** @brief The picture of such a file, upright, 8 bits, BGR or BGRA.
@throws FileTrouble if it is damaged, or if the program was built without libheif */
cv::Mat readHeif(const std::string& path);

#endif
