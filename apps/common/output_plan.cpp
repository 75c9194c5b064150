// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#include "common/output_plan.hpp"

#include <filesystem>
#include <opencv2/imgcodecs.hpp>
#include <unistd.h>
#include "common/exit_code.hpp"
#include "common/paths.hpp"

namespace fs = std::filesystem;

namespace
{

/// Throws FileTrouble unless files can be made in this folder.
void checkWritable(const std::string& path, const fs::path& folder)
{
    std::error_code error;
    const fs::file_status status = fs::status(folder, error);
    if (!fs::exists(status))
        throw FileTrouble("cannot write " + shortened(path) + ": there is no folder " + shortened(folder.string()) +
                          "; make it first");
    if (!fs::is_directory(status))
        throw FileTrouble("cannot write " + shortened(path) + ": " + shortened(folder.string()) +
                          " is no folder; choose another place");
    if (access(folder.c_str(), W_OK | X_OK) != 0)
        throw FileTrouble("cannot write " + shortened(path) + ": the folder " + shortened(folder.string()) +
                          " may not be written to; change its permissions or choose another place");
}

/// The nearest folder above that is there.
fs::path presentFolder(fs::path folder)
{
    std::error_code error;
    while (!fs::exists(folder, error) && !error && folder.has_parent_path() && folder != folder.parent_path())
        folder = folder.parent_path();
    return folder.empty() || !fs::exists(folder, error) ? fs::path(".") : folder;
}

} // namespace

void OutputPlan::add(const std::string& option, const std::string& path, Kind kind)
{
    if (!path.empty())
        outputs_.push_back({option, path, kind});
}

void OutputPlan::checkFolder(const Output& output, bool force) const
{
    const std::string said = output.option + "=" + shortened(output.path);
    for (const std::string& input : inputs_)
        if (isSameFile(output.path, folderOf(input)))
            throw WrongUse(said + " could overwrite " + input + ", which lies there: choose another folder");
    std::error_code error;
    const fs::file_status status = fs::status(output.path, error);
    if (status.type() == fs::file_type::none)
        throw FileTrouble("cannot write into " + shortened(output.path) + ": " + error.message());
    if (fs::exists(status) && !fs::is_directory(status))
        throw WrongUse(said + " is a file, and a folder is needed: choose another name");
    if (!fs::exists(status))
        checkWritable(output.path, presentFolder(folderOf(output.path)));
    else
    {
        checkWritable(output.path + "/..", output.path);
        if (!force && !fs::is_empty(output.path, error))
            throw WrongUse("the folder " + shortened(output.path) + " of " + output.option +
                           " is not empty: choose another one, or add --force to replace files in it");
    }
}

void OutputPlan::checkFile(const Output& output, bool force) const
{
    for (const std::string& input : inputs_)
        if (isSameFile(output.path, input))
            throw WrongUse(output.option + "=" + shortened(output.path) + ": " + input +
                           " is read, and would be overwritten; choose another name");
    if (isDevice(output.path))
        return;
    if (output.kind == Kind::PICTURE && !cv::haveImageWriter(output.path))
        throw WrongUse("no picture can be written under the name " + shortened(output.path) +
                       ": its ending must be one that is known, such as .jpg, .png, .tif or .webp");
    std::error_code error;
    const fs::file_status status = fs::status(output.path, error);
    if (status.type() == fs::file_type::none) // the name is too long, links lead in a circle, ..
        throw FileTrouble("cannot write " + shortened(output.path) + ": " + error.message());
    if (fs::is_directory(status))
        throw WrongUse(output.option + "=" + shortened(output.path) + " is a folder, and the name of a file is needed");
    checkWritable(output.path, folderOf(output.path));
    if (fs::exists(status) && !force)
        throw WrongUse(shortened(output.path) + " exists: choose another name with " + output.option +
                       ", or add --force to replace it");
}

void OutputPlan::check(bool force) const
{
    for (size_t i = 0; i < outputs_.size(); ++i)
    {
        const Output& output = outputs_[i];
        for (size_t k = 0; k < i; ++k)
            if (isSameFile(output.path, outputs_[k].path) && !isDevice(output.path))
                throw WrongUse(output.option + " and " + outputs_[k].option + " name one file, " +
                               shortened(output.path) + ", which would be overwritten; give them different names");
        if (output.kind == Kind::FOLDER)
            checkFolder(output, force);
        else
            checkFile(output, force);
    }
}

bool OutputPlan::usesStandardOutput() const
{
    for (const Output& output : outputs_)
        if (isStandardOutput(output.path))
            return true;
    return false;
}
