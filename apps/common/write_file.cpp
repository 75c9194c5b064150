// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#include "common/write_file.hpp"

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <opencv2/imgcodecs.hpp>
#include "common/exit_code.hpp"
#include "common/held_signals.hpp"
#include "common/partial_file.hpp"
#include "common/paths.hpp"

namespace fs = std::filesystem;

namespace
{

std::string reasonOf(int number)
{
    if (number == ENOSPC || number == EFBIG || number == EDQUOT)
        return "the disk is full or the file is too large; make room or choose another place";
    return number == 0 ? "the system does not say why" : std::strerror(number);
}

/// Returns what went wrong, or nothing.
std::string put(std::FILE* file, const uchar* data, size_t size)
{
    const bool whole = std::fwrite(data, 1, size, file) == size && std::fflush(file) == 0;
    return whole ? "" : reasonOf(errno);
}

/// Returns what went wrong, or nothing.
std::string putInto(const fs::path& path, const uchar* data, size_t size)
{
    errno = 0;
    std::FILE* const file = std::fopen(path.c_str(), "wb");
    if (!file)
        return reasonOf(errno);
    const std::string reason = put(file, data, size);
    const bool closed = std::fclose(file) == 0;
    return reason.empty() && !closed ? reasonOf(errno) : reason;
}

/// Returns what went wrong, or nothing.
std::string replace(const fs::path& path, const uchar* data, size_t size)
{
    const HeldSignals held;
    PartialFile partial(path.string());
    const std::string reason = putInto(partial.name(), data, size);
    return reason.empty() ? partial.commit() : reason;
}

} // namespace

void writeBytes(const std::string& path, const uchar* data, size_t size)
{
    std::string reason;
    if (isStandardOutput(path))
        reason = put(stdout, data, size);
    else if (isDevice(path))
        reason = putInto(path, data, size);
    else
        reason = replace(path, data, size);
    if (!reason.empty())
        throw FileTrouble("cannot write " + shortened(path) + ": " + reason);
}

void writeText(const std::string& path, const std::string& text)
{
    writeBytes(path, reinterpret_cast<const uchar*>(text.data()), text.size());
}

void writeImage(const std::string& path, const cv::Mat& image)
{
    std::vector<uchar> data;
    const std::string ending = endingOf(path);
    if (!cv::imencode(ending, image, data))
        throw FileTrouble("cannot write " + shortened(path) + ": OpenCV cannot encode the picture as " + ending);
    writeBytes(path, data.data(), data.size());
}

void writeModel(const std::string& path, const std::function<void(const std::string&)>& save)
{
    try
    {
        if (isDevice(path))
            save(path); // may last until somebody reads
        else
        {
            const HeldSignals held;
            save(path);
        }
    }
    catch (const cv::Exception& error)
    {
        throw FileTrouble("cannot write " + shortened(path) + ": " + error.err);
    }
}

void makeFolder(const std::string& path)
{
    std::error_code error;
    fs::create_directories(path, error);
    std::error_code unknown;
    if (!fs::is_directory(path, unknown))
        throw FileTrouble("cannot make the folder " + shortened(path) + (error ? ": " + error.message() : ""));
}
