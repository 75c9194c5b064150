// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#ifndef GCPW_APPS_EMBED_HPP
#define GCPW_APPS_EMBED_HPP

#include <vector>
#include <opencv2/core.hpp>

/** @brief Puts EXIF and a colour profile into a PNG or WebP file, where Exiv2 0.27 writes profiles that other programs do not find.
@param file as cv::imencode() makes it  @param exif, profile may be empty */
std::vector<uchar> embedInPng(const std::vector<uchar>& file, const std::vector<uchar>& exif,
                              const std::vector<uchar>& profile);
std::vector<uchar> embedInWebp(const std::vector<uchar>& file, const std::vector<uchar>& exif,
                               const std::vector<uchar>& profile, cv::Size size);

bool isPng(const std::vector<uchar>& file);
bool isWebp(const std::vector<uchar>& file);

#endif
