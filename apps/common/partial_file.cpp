// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#include "common/partial_file.hpp"

#include "common/exit_code.hpp"
#include "common/paths.hpp"

namespace fs = std::filesystem;

namespace
{

/// An unused name in the same folder for what is not complete yet.
fs::path partialOf(const fs::path& path)
{
    const size_t most = 200; // of 255 letters that a name may have
    for (int i = 0;; ++i)
    {
        const fs::path partial =
            path.parent_path() / (path.filename().string().substr(0, most) + ".partial" + std::to_string(i));
        std::error_code unknown;
        if (!fs::exists(fs::symlink_status(partial, unknown)))
            return partial;
    }
}

} // namespace

PartialFile::PartialFile(const std::string& path)
{
    std::error_code error;
    target_ = fs::exists(path, error) ? fs::canonical(path, error) : fs::path(path);
    if (error)
        throw FileTrouble("cannot write " + shortened(path) + ": " + error.message());
    partial_ = partialOf(target_);
}

PartialFile::~PartialFile()
{
    std::error_code ignored;
    if (!committed_)
        fs::remove_all(partial_, ignored);
}

std::string PartialFile::commit()
{
    std::error_code error;
    if (fs::is_directory(partial_, error)) // no folder takes the place of one that holds something
        fs::remove_all(target_, error);
    fs::rename(partial_, target_, error);
    committed_ = !error;
    return error ? error.message() : "";
}
