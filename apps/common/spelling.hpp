// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#ifndef GCPW_APPS_SPELLING_HPP
#define GCPW_APPS_SPELLING_HPP

#include <string>
#include <vector>

/// The word that was probably meant: the one with the fewest letters to change, add, drop or swap. Empty if none is near.
std::string nearestWord(const std::string& written, const std::vector<std::string>& words);

/// "a, b or c".
std::string listed(const std::vector<std::string>& words);

#endif
