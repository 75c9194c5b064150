// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#ifndef GCPW_APPS_OUTPUT_PLAN_HPP
#define GCPW_APPS_OUTPUT_PLAN_HPP

#include <string>
#include <vector>

/** @brief All files that a program is going to read and to write, checked before it works.

No input is overwritten, no two outputs are one file, files that exist are replaced only if the caller says so, and folders of
outputs are there. Devices and pipes are always written. */
class OutputPlan
{
public:
    /// A file that is read.
    void reads(const std::string& path) { inputs_.push_back(path); }

    /// @param option that named it  @param path empty for none
    void writesPicture(const std::string& option, const std::string& path) { add(option, path, Kind::PICTURE); }
    void writesFile(const std::string& option, const std::string& path) { add(option, path, Kind::OTHER); }
    /// The folder's files have names that the program chooses; it is made where it is missing.
    void writesFolder(const std::string& option, const std::string& path) { add(option, path, Kind::FOLDER); }

    /** @brief Refuses what cannot or must not be written.
    @param force files that exist may be replaced
    @throws WrongUse, or FileTrouble where the system refuses; both name the file and say what to do */
    void check(bool force) const;

    /// Whether something goes to standard output.
    bool usesStandardOutput() const;

private:
    enum class Kind
    {
        PICTURE,
        OTHER,
        FOLDER
    };

    struct Output
    {
        std::string option;
        std::string path;
        Kind kind;
    };

    void add(const std::string& option, const std::string& path, Kind kind);
    void checkFolder(const Output& output, bool force) const;
    void checkFile(const Output& output, bool force) const;

    std::vector<std::string> inputs_;
    std::vector<Output> outputs_;
};

#endif
