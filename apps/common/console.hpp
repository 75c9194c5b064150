// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#ifndef GCPW_APPS_CONSOLE_HPP
#define GCPW_APPS_CONSOLE_HPP

#include <string>

/** @brief What a program says: results to standard output, warnings to standard error, each on a line of its own.

Where a picture or a report goes to standard output itself, results go to standard error too. */
class Console
{
public:
    enum class Loudness
    {
        QUIET, ///< warnings and errors only
        NORMAL,
        VERBOSE
    };

    /// @param program named in warnings
    Console(const std::string& program, Loudness loudness) : program_(program), loudness_(loudness) {}

    Loudness loudness() const { return loudness_; }

    /// From now on standard output belongs to data.
    void keepOutputFree() { output_is_free_ = false; }

    /// A result or a choice; silent if quiet.
    void tell(const std::string& sentence) const;

    /// What only --verbose tells.
    void detail(const std::string& sentence) const;

    /// What the user should know of in any case.
    void warn(const std::string& sentence) const;

    /// Throws FileTrouble if what was said could not be written, as on a full disk.
    void flush() const;

private:
    std::string program_;
    Loudness loudness_;
    bool output_is_free_ = true;
};

#endif
