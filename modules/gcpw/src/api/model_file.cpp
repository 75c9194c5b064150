// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#include "api/model_file.hpp"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <sstream>
#include "api/gzip.hpp"
#include "api/model_text.hpp"

namespace cv
{
namespace gcpw
{

namespace
{

namespace fs = std::filesystem;

const int FORMAT = 1;               ///< raised when a reader of the older kind would misread the file
const char* const END = "complete"; ///< the last thing in a file
const char* const NO_ROOM = ": the disk is full or the file is too large";
const size_t MOST_TEXT = 256 << 20; ///< bytes of unpacked text: a thousand images with the default mesh, 20 with the finest

bool opened(FileStorage& file, const std::string& name, int mode, std::string& reason)
{
    try
    {
        return file.open(name, mode);
    }
    catch (const cv::Exception& e)
    {
        reason = ": " + e.err;
        return false;
    }
}

[[noreturn]] void cannotWrite(const std::string& path, const std::string& reason)
{
    CV_Error(Error::StsError, "gcpw: cannot write " + path + reason);
}

bool isCompressed(const fs::path& path)
{
    return path.extension() == ".gz";
}

/// What OpenCV's parser would crash at or take all memory for.
std::string faultOf(const std::string& path)
{
    std::ifstream stream(path, std::ios::binary);
    const bool gzip = stream.get() == 0x1f && stream.get() == 0x8b;
    stream.clear();
    stream.seekg(0);
    if (!gzip)
        return textFault(stream);
    try
    {
        std::istringstream text(gunzip(stream, MOST_TEXT));
        return textFault(text);
    }
    catch (const cv::Exception& e)
    {
        return e.err;
    }
}

/// Where the file is written first: in the same folder, with the same extensions, under an unused name.
fs::path unusedNeighbour(const fs::path& path)
{
    fs::path stem = path.stem();
    std::string ending = path.extension().string();
    if (isCompressed(path))
    {
        ending = stem.extension().string() + ending;
        stem = stem.stem();
    }
    for (int i = 0;; ++i)
    {
        const fs::path candidate = path.parent_path() / (stem.string() + ".part" + std::to_string(i) + ending);
        std::error_code unknown;
        if (!fs::exists(fs::symlink_status(candidate, unknown)))
            return candidate;
    }
}

typedef std::function<void(FileStorage&)> Write;

void writeAll(FileStorage& file, const std::string& kind, const Write& write)
{
    file << "format" << FORMAT << "kind" << kind;
    write(file);
    file << END << 1;
}

std::string textOf(const std::string& path, const std::string& kind, const Write& write)
{
    FileStorage file;
    std::string reason;
    if (!opened(file, path, FileStorage::WRITE | FileStorage::MEMORY, reason))
        cannotWrite(path, reason);
    writeAll(file, kind, write);
    return file.releaseAndGetString();
}

/// FileStorage does not say whether the bytes reached the file; a stream does. Returns what went wrong, or nothing.
std::string writeText(const fs::path& path, const std::string& text)
{
    std::ofstream stream(path, std::ios::binary);
    if (!stream)
        return ": is the folder there and writable?";
    stream.write(text.data(), static_cast<std::streamsize>(text.size()));
    stream.close();
    return stream ? "" : NO_ROOM;
}

/// Only FileStorage can compress; what it wrote is checked afterwards.
std::string writeCompressed(const std::string& path, const std::string& kind, const Write& write)
{
    FileStorage file;
    std::string reason;
    if (!opened(file, path, FileStorage::WRITE, reason))
        return reason.empty() ? ": is the folder there and writable?" : reason;
    writeAll(file, kind, write);
    file.release();
    return opened(file, path, FileStorage::READ, reason) && !file[END].empty() ? "" : NO_ROOM;
}

/// @param target is replaced, or untouched where a reason is returned
std::string writeBeside(const fs::path& target, const std::function<std::string(const fs::path&)>& write)
{
    const fs::path partial = unusedNeighbour(target);
    std::error_code failed;
    try
    {
        std::string reason = write(partial);
        if (reason.empty())
        {
            fs::rename(partial, target, failed);
            reason = failed ? ": " + failed.message() : "";
        }
        if (!reason.empty())
            fs::remove(partial, failed);
        return reason;
    }
    catch (...)
    {
        fs::remove(partial, failed);
        throw;
    }
}

} // namespace

void writeFile(const std::string& name, const std::string& kind, const Write& write)
{
    const bool compressed = isCompressed(name);
    const std::string text = compressed ? std::string() : textOf(name, kind, write);
    std::error_code failed;
    const fs::file_status before = fs::status(name, failed);
    std::string reason;
    if (!fs::exists(before) || fs::is_regular_file(before))
    {
        // A link stays one: what it leads to is replaced.
        const fs::path target = fs::exists(before) ? fs::canonical(name, failed) : fs::path(name);
        reason = writeBeside(target,
                             [&](const fs::path& partial) {
            return compressed ? writeCompressed(partial.string(), kind, write) : writeText(partial, text);
        });
    }
    else if (compressed || fs::is_directory(before))
        reason = ": it is no regular file";
    else
        reason = writeText(name, text);
    if (!reason.empty())
        cannotWrite(name, reason);
}

FileStorage openForReading(const std::string& path, const std::string& kind)
{
    const std::string fault = faultOf(path);
    if (!fault.empty())
        CV_Error(Error::StsParseError, "gcpw: cannot read " + path + ": " + fault);
    FileStorage file;
    std::string reason;
    if (!opened(file, path, FileStorage::READ, reason))
        CV_Error(reason.empty() ? Error::StsError : Error::StsParseError, "gcpw: cannot read " + path + reason);
    std::string found;
    int format = 0;
    file["kind"] >> found;
    file["format"] >> format;
    if (found != kind || format != FORMAT)
        CV_Error(Error::StsParseError,
                 "gcpw: " + path + " is not a file of kind " + kind + ", format " + std::to_string(FORMAT));
    return file;
}

Mat readMatrix(const FileNode& node, const char* name, int rows, int cols, const std::vector<std::string>& elements)
{
    if (!node.isMap() || !node["sizes"].empty())
        CV_Error(Error::StsParseError, format("%s is missing or no matrix", name));
    const int found_rows = static_cast<int>(node["rows"]);
    const int found_cols = static_cast<int>(node["cols"]);
    if (found_rows == 0 && found_cols == 0)
        return {};
    const std::string element = static_cast<std::string>(node["dt"]);
    if (found_rows < 0 || found_rows > rows || found_cols < 0 || found_cols > cols ||
        std::find(elements.begin(), elements.end(), element) == elements.end())
        CV_Error(Error::StsParseError,
                 format("%s is a matrix of %d x %d elements of kind '%s'; at most %d x %d of kind '%s' are read", name,
                        found_rows, found_cols, element.c_str(), rows, cols, elements.front().c_str()));
    Mat matrix;
    node >> matrix;
    return matrix;
}

} // namespace gcpw
} // namespace cv
