// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#ifndef GCPW_EVALUATION_CHILD_PROCESS_HPP
#define GCPW_EVALUATION_CHILD_PROCESS_HPP

#include <string>
#include <vector>

namespace evaluation
{

/// What a program was, once it has ended.
struct ChildResult
{
    int exit_code = 0; ///< 128 + signal if it was killed
    double seconds = 0; ///< wall time
    double cpu_seconds = 0; ///< processor time of all its threads, which the load of the machine hardly changes
    double peak_mb = 0; ///< largest resident memory, MiB
};

/** @brief Runs a program and waits for it; its standard output is dropped.
@param arguments without the program itself
@throws cv::Exception if it cannot be started */
ChildResult runChild(const std::string& program, const std::vector<std::string>& arguments);

} // namespace evaluation

#endif
