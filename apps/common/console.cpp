// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#include "common/console.hpp"

#include <cstdio>
#include <iostream>
#include "common/exit_code.hpp"
#include "common/progress_line.hpp"

void Console::tell(const std::string& sentence) const
{
    if (loudness_ == Loudness::QUIET)
        return;
    ProgressLine::erase();
    (output_is_free_ ? std::cout : std::cerr) << sentence << '\n';
}

void Console::detail(const std::string& sentence) const
{
    if (loudness_ == Loudness::VERBOSE)
        tell(sentence);
}

void Console::warn(const std::string& sentence) const
{
    ProgressLine::erase();
    std::cerr << program_ << ": " << sentence << '\n';
}

void Console::flush() const
{
    std::cout.flush();
    if (!std::cout || std::fflush(stdout) != 0 || std::ferror(stdout) != 0)
        throw FileTrouble("cannot write to standard output: the disk is full or the file is too large");
}
