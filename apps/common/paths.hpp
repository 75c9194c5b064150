// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#ifndef GCPW_APPS_PATHS_HPP
#define GCPW_APPS_PATHS_HPP

#include <filesystem>
#include <string>

/// "-" and the names that systems have for standard output.
bool isStandardOutput(const std::string& path);

/// A device, a pipe or standard output: written directly, as nothing is there to be replaced.
bool isDevice(const std::string& path);

/// Whether both names lead to one file, which need not be there yet.
bool isSameFile(const std::filesystem::path& a, const std::filesystem::path& b);

/// The folder in which a file lies: "." where its name has none.
std::filesystem::path folderOf(const std::filesystem::path& path);

/// ".png", in small letters.
std::string endingOf(const std::string& path);

/// A name for messages: in full, or its ends if it is very long.
std::string shortened(const std::string& path);

#endif
