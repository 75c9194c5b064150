// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#ifndef GCPW_APPS_PARTIAL_FILE_HPP
#define GCPW_APPS_PARTIAL_FILE_HPP

#include <filesystem>
#include <string>

/** @brief The place of a file or folder that is being written: an unused name beside its own, which it takes when it is whole.

A link stays one: what it leads to is replaced. */
class PartialFile
{
public:
    /// Makes nothing. @throws FileTrouble if a link leads nowhere
    explicit PartialFile(const std::string& path);
    /// Removes what was not committed.
    ~PartialFile();
    PartialFile(const PartialFile&) = delete;
    PartialFile& operator=(const PartialFile&) = delete;

    /// Where to write.
    std::string name() const { return partial_.string(); }

    /// Gives it its name, in the place of what has it. @return what went wrong, or nothing
    std::string commit();

private:
    std::filesystem::path target_;
    std::filesystem::path partial_;
    bool committed_ = false;
};

#endif
