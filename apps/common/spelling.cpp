// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#include "common/spelling.hpp"

#include <algorithm>
#include <cctype>

namespace
{

std::string lowered(std::string text)
{
    for (char& letter : text)
        letter = letter == '-' ? '_' : static_cast<char>(std::tolower(static_cast<unsigned char>(letter)));
    return text;
}

/// How many letters have to be changed, added, dropped or swapped with their neighbour.
size_t distance(const std::string& a, const std::string& b)
{
    std::vector<size_t> two_before(b.size() + 1);
    std::vector<size_t> before(b.size() + 1);
    std::vector<size_t> row(b.size() + 1);
    for (size_t j = 0; j <= b.size(); ++j)
        before[j] = j;
    for (size_t i = 1; i <= a.size(); ++i)
    {
        row[0] = i;
        for (size_t j = 1; j <= b.size(); ++j)
        {
            const size_t changed = a[i - 1] == b[j - 1] ? 0 : 1;
            row[j] = std::min({before[j] + 1, row[j - 1] + 1, before[j - 1] + changed});
            if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1])
                row[j] = std::min(row[j], two_before[j - 2] + 1);
        }
        two_before.swap(before);
        before.swap(row);
    }
    return before[b.size()];
}

} // namespace

std::string nearestWord(const std::string& written, const std::vector<std::string>& words)
{
    // A third of the letters may be wrong: farther words have nothing to do with what was written.
    const size_t share = 3;
    std::string nearest;
    size_t least = std::max<size_t>(written.size() / share, 1) + 1;
    for (const std::string& word : words)
    {
        const bool begun = written.size() >= share && lowered(word).compare(0, written.size(), lowered(written)) == 0;
        const size_t changes = begun ? 1 : distance(lowered(written), lowered(word));
        if (changes < least)
        {
            least = changes;
            nearest = word;
        }
    }
    return nearest;
}

std::string listed(const std::vector<std::string>& words)
{
    std::string text;
    for (size_t i = 0; i < words.size(); ++i)
        text += (i == 0 ? "" : i + 1 == words.size() ? " or " : ", ") + words[i];
    return text;
}
