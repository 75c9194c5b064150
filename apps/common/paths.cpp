// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#include "common/paths.hpp"

#include <cctype>

namespace fs = std::filesystem;

bool isStandardOutput(const std::string& path)
{
    return path == "-" || path == "/dev/stdout" || path == "/dev/fd/1" || path == "/proc/self/fd/1";
}

bool isDevice(const std::string& path)
{
    std::error_code unknown;
    const fs::file_status status = fs::status(path, unknown);
    return isStandardOutput(path) || (fs::exists(status) && !fs::is_regular_file(status) && !fs::is_directory(status));
}

bool isSameFile(const fs::path& a, const fs::path& b)
{
    std::error_code unknown;
    if (fs::equivalent(a, b, unknown))
        return true;
    std::error_code unknown_a;
    std::error_code unknown_b;
    const fs::path whole_a = fs::weakly_canonical(a, unknown_a);
    const fs::path whole_b = fs::weakly_canonical(b, unknown_b);
    return !unknown_a && !unknown_b && whole_a == whole_b;
}

fs::path folderOf(const fs::path& path)
{
    return path.has_parent_path() ? path.parent_path() : fs::path(".");
}

std::string endingOf(const std::string& path)
{
    std::string ending = fs::path(path).extension().string();
    for (char& letter : ending)
        letter = static_cast<char>(std::tolower(static_cast<unsigned char>(letter)));
    return ending;
}

std::string shortened(const std::string& path)
{
    const size_t most = 160;
    const size_t end = 60;
    return path.size() <= most ? path : path.substr(0, end) + " .. " + path.substr(path.size() - end);
}
