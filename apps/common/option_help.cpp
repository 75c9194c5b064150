// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#include "common/option_help.hpp"

#include <sstream>

namespace
{

const size_t COLUMN = 28; ///< where the second column begins
const size_t WIDTH = 100; ///< of a line

} // namespace

std::string optionHelp(const std::string& names, const std::string& kind, const std::string& preset,
                       const std::string& help)
{
    const bool has_letter = names[1] != '-';
    std::string line = has_letter ? "  " + names.substr(0, 2) + ", " + names.substr(3) : "      " + names;
    if (!kind.empty())
        line += " " + kind;
    std::string text;
    if (line.size() + 1 > COLUMN)
    {
        text = line + "\n";
        line.clear();
    }
    line.resize(COLUMN, ' ');
    std::istringstream words(help + (preset.empty() ? "" : " [" + preset + "]"));
    bool is_first = true;
    for (std::string word; words >> word; is_first = false)
    {
        if (!is_first && line.size() + 1 + word.size() > WIDTH)
        {
            text += line + "\n";
            line.assign(COLUMN, ' ');
            is_first = true;
        }
        line += (is_first ? "" : " ") + word;
    }
    return text + line + "\n";
}
