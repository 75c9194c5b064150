// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#include "common/input_list.hpp"

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <fstream>
#include <set>
#include <glob.h>
#include "common/exit_code.hpp"
#include "common/paths.hpp"

namespace fs = std::filesystem;

namespace
{

const std::set<std::string> PICTURE_ENDINGS = {".jpg",  ".jpeg", ".jpe",  ".png", ".tif", ".tiff", ".webp",
                                               ".bmp",  ".dib",  ".pgm",  ".ppm", ".pbm", ".pnm",  ".jp2",
                                               ".heic", ".heif", ".avif", ".sr",  ".ras"};
const int MOST_LISTS = 8; ///< lists inside lists: more lead in a circle

bool isDigit(char letter)
{
    return std::isdigit(static_cast<unsigned char>(letter)) != 0;
}

/// The digits from `begin` on, without leading zeros.
std::string digitsAt(const std::string& text, size_t begin, size_t& end)
{
    end = begin;
    while (end < text.size() && isDigit(text[end]))
        ++end;
    while (begin + 1 < end && text[begin] == '0')
        ++begin;
    return text.substr(begin, end - begin);
}

std::vector<std::string> inOrder(std::vector<std::string> paths)
{
    std::sort(paths.begin(), paths.end(), comesBefore);
    return paths;
}

std::vector<std::string> picturesIn(const std::string& folder)
{
    std::vector<std::string> paths;
    std::error_code error;
    for (fs::directory_iterator entry(folder, error), end; !error && entry != end; entry.increment(error))
    {
        std::error_code unknown;
        const std::string path = entry->path().string();
        const bool hidden = entry->path().filename().string()[0] == '.';
        if (!hidden && PICTURE_ENDINGS.count(endingOf(path)) > 0 && !fs::is_directory(entry->path(), unknown))
            paths.push_back(path);
    }
    if (error)
        throw FileTrouble("cannot read the folder " + shortened(folder) + ": " + error.message());
    if (paths.empty())
        throw FileTrouble("in the folder " + shortened(folder) + " lie no pictures");
    return inOrder(paths);
}

std::vector<std::string> filesLike(const std::string& pattern)
{
    glob_t found = {};
    std::vector<std::string> paths;
    if (glob(pattern.c_str(), 0, nullptr, &found) == 0)
        paths.assign(found.gl_pathv, found.gl_pathv + found.gl_pathc);
    globfree(&found);
    if (paths.empty())
        throw FileTrouble("no file has a name like " + shortened(pattern));
    return inOrder(paths);
}

std::vector<std::string> linesOf(const std::string& list)
{
    std::ifstream file(list);
    std::error_code error;
    if (!file || fs::is_directory(list, error))
        throw FileTrouble("cannot read the list " + shortened(list) + ": is it there?");
    std::vector<std::string> lines;
    for (std::string line; std::getline(file, line);)
    {
        const size_t begin = line.find_first_not_of(" \t\r");
        const size_t end = line.find_last_not_of(" \t\r");
        if (begin == std::string::npos || line[begin] == '#')
            continue;
        line = line.substr(begin, end - begin + 1);
        const bool is_list = line[0] == '@';
        const fs::path path = is_list ? line.substr(1) : line;
        const std::string placed =
            path.is_absolute() ? path.string() : (folderOf(list) / path).lexically_normal().string();
        lines.push_back(is_list ? "@" + placed : placed);
    }
    if (lines.empty())
        throw FileTrouble("the list " + shortened(list) + " names no photographs");
    return lines;
}

void addTo(std::vector<std::string>& paths, const std::string& argument, int depth)
{
    std::error_code unknown;
    if (fs::is_directory(argument, unknown))
    {
        const std::vector<std::string> found = picturesIn(argument);
        paths.insert(paths.end(), found.begin(), found.end());
    }
    else if (fs::exists(argument, unknown))
        paths.push_back(argument);
    else if (argument[0] == '@')
    {
        if (depth >= MOST_LISTS)
            throw FileTrouble("the list " + shortened(argument.substr(1)) + " leads to itself");
        for (const std::string& line : linesOf(argument.substr(1)))
            addTo(paths, line, depth + 1);
    }
    else if (argument.find_first_of("*?[") != std::string::npos)
    {
        const std::vector<std::string> found = filesLike(argument);
        for (const std::string& path : found)
            if (!fs::is_directory(path, unknown))
                paths.push_back(path);
    }
    else
        paths.push_back(argument); // reading it says what is wrong
}

} // namespace

bool comesBefore(const std::string& a, const std::string& b)
{
    size_t i = 0;
    size_t j = 0;
    while (i < a.size() && j < b.size())
    {
        if (isDigit(a[i]) && isDigit(b[j]))
        {
            const std::string number_a = digitsAt(a, i, i);
            const std::string number_b = digitsAt(b, j, j);
            if (number_a.size() != number_b.size())
                return number_a.size() < number_b.size();
            if (number_a != number_b)
                return number_a < number_b;
            continue;
        }
        const int letter_a = std::tolower(static_cast<unsigned char>(a[i++]));
        const int letter_b = std::tolower(static_cast<unsigned char>(b[j++]));
        if (letter_a != letter_b)
            return letter_a < letter_b;
    }
    const bool a_ends = i == a.size();
    const bool b_ends = j == b.size();
    return a_ends != b_ends ? a_ends : a < b;
}

std::vector<std::string> listPhotographs(const std::vector<std::string>& arguments)
{
    std::vector<std::string> all;
    for (const std::string& argument : arguments)
        addTo(all, argument, 0);
    std::vector<std::string> once;
    std::set<std::string> seen;
    for (const std::string& path : all)
    {
        std::error_code error;
        const fs::path whole = fs::canonical(path, error);
        if (seen.insert(error ? path : whole.string()).second)
            once.push_back(path);
    }
    return once;
}
