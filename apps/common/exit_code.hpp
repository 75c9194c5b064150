// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#ifndef GCPW_APPS_EXIT_CODE_HPP
#define GCPW_APPS_EXIT_CODE_HPP

#include <stdexcept>

/// Exit codes of the programs.
enum ExitCode
{
    EXIT_STITCHED = 0,
    EXIT_NO_ANSWER = 1, ///< the photographs have none: they do not match, or ask for an absurd picture
    EXIT_WRONG_USE = 2,
    EXIT_FILE_TROUBLE = 3 ///< something could not be read or written
};

/// The caller asked for something that cannot be: ends the program with EXIT_WRONG_USE and this message.
struct WrongUse : std::runtime_error
{
    using std::runtime_error::runtime_error;
};

/// A file could not be read or written: ends the program with EXIT_FILE_TROUBLE and this message, which names the file.
struct FileTrouble : std::runtime_error
{
    using std::runtime_error::runtime_error;
};

#endif
