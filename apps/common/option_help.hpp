// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#ifndef GCPW_APPS_OPTION_HELP_HPP
#define GCPW_APPS_OPTION_HELP_HPP

#include <string>

/** @brief The lines of one option in a program's help: its names in one column, what it does in another.
@param names "-o,--output"  @param kind what the value is, empty for a flag  @param preset the default, may be empty */
std::string optionHelp(const std::string& names, const std::string& kind, const std::string& preset,
                       const std::string& help);

#endif
