// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#ifndef GCPW_APPS_WRITE_FILE_HPP
#define GCPW_APPS_WRITE_FILE_HPP

#include <functional>
#include <string>
#include <vector>
#include <opencv2/core.hpp>

/** @brief Writes a file as a whole or not at all.

The bytes go to a new file beside it, which then takes its name; no signal stops that halfway. A link stays one: what it leads to is
replaced. Devices, pipes and standard output ("-") get the bytes directly.
@throws FileTrouble that names the file and says why */
void writeBytes(const std::string& path, const uchar* data, size_t size);

/// The same for text.
void writeText(const std::string& path, const std::string& text);

/// The same for a picture as its ending says, without settings or metadata; see encodePicture() for these.
void writeImage(const std::string& path, const cv::Mat& image);

/// Calls save(path), which writes a file as a whole or not at all, and lets no signal stop it halfway.
void writeModel(const std::string& path, const std::function<void(const std::string&)>& save);

/// Makes a folder and its parents. @throws FileTrouble
void makeFolder(const std::string& path);

#endif
