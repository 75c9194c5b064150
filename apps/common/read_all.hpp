// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#ifndef GCPW_APPS_READ_ALL_HPP
#define GCPW_APPS_READ_ALL_HPP

#include <functional>
#include <string>
#include <vector>
#include "common/console.hpp"
#include "common/progress_line.hpp"
#include "common/read_photograph.hpp"

const int MIN_SIDE = 8; ///< px of a photograph: cv::SIFT fails on images of one or two

/** @brief Reads photographs.
@param skip_bad those that cannot be read are told and left out; else the first one ends in FileTrouble */
std::vector<Photograph> readAll(const std::vector<std::string>& paths, bool skip_bad, const Console& console,
                                ProgressLine& progress);

/// The same. @param on_read called with each photograph that could be read; may take a part of it away
std::vector<Photograph> readAll(const std::vector<std::string>& paths, bool skip_bad, const Console& console,
                                ProgressLine& progress, const std::function<void(Photograph&)>& on_read);

/// What a picture of these photographs is to carry: the metadata of the first. Warns where colour profiles differ.
Metadata sharedMetadata(const std::vector<Photograph>& photographs, const std::vector<int>& kept,
                        const Console& console);

#endif
