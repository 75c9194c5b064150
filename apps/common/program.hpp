// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#ifndef GCPW_APPS_PROGRAM_HPP
#define GCPW_APPS_PROGRAM_HPP

#include <functional>
#include <string>
#include <opencv2/gcpw/params.hpp>
#include "common/command_line.hpp"
#include "common/console.hpp"
#include "common/exit_code.hpp"

/// Least resolution of an estimation that makes sense, million pixels: a photograph of 10 x 10 px.
const double LEAST_MEGAPIX = 1e-4;
/// The largest that OpenCV has pictures of.
const double MOST_MEGAPIX = 1000;

/// Applies "name=value,name=value" to params, and checks all of them. Throws WrongUse.
void applySettings(const std::string& settings, cv::gcpw::Params& params);

/** @brief A program's main(): parses, shows help or version or calls run(), and turns exceptions into a message and an exit code.
@param line with the options declared  @param run the work; returns the exit code */
int runProgram(CommandLine& line, int argc, const char* const* argv, const std::function<int(Console&)>& run);

#endif
