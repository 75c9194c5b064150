// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#include "evaluation/child_process.hpp"

#include <cerrno>
#include <fcntl.h>
#include <fstream>
#include <opencv2/core.hpp>
#include <opencv2/core/utility.hpp>
#include <spawn.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

namespace evaluation
{

namespace
{

/** @brief Makes Linux forget how much memory this process once used.

A child inherits it as its own peak, since it begins in its parent's memory. Where the file cannot be written the peak stays
what it was. */
void forgetPeak()
{
    std::ofstream("/proc/self/clear_refs") << 5; // 5: the peak, see proc(5)
}

} // namespace

ChildResult runChild(const std::string& program, const std::vector<std::string>& arguments)
{
    std::vector<char*> argv(1, const_cast<char*>(program.c_str())); // posix_spawn does not write to them
    for (const std::string& argument : arguments)
        argv.push_back(const_cast<char*>(argument.c_str()));
    argv.push_back(nullptr);
    posix_spawn_file_actions_t files;
    posix_spawn_file_actions_init(&files);
    posix_spawn_file_actions_addopen(&files, STDOUT_FILENO, "/dev/null", O_WRONLY, 0);
    forgetPeak();
    cv::TickMeter clock;
    clock.start();
    pid_t child = 0;
    const int failed = posix_spawn(&child, program.c_str(), &files, nullptr, argv.data(), environ);
    posix_spawn_file_actions_destroy(&files);
    if (failed)
        CV_Error(cv::Error::StsError, "cannot run " + program + "; is it built?");
    int status = 0;
    rusage usage = {};
    while (wait4(child, &status, 0, &usage) < 0)
        if (errno != EINTR)
            CV_Error(cv::Error::StsError, "lost sight of " + program);
    clock.stop();
    ChildResult result;
    result.exit_code = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
    result.seconds = clock.getTimeSec();
    for (const timeval& time : {usage.ru_utime, usage.ru_stime})
        result.cpu_seconds += static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
    result.peak_mb = static_cast<double>(usage.ru_maxrss) / 1024; // Linux counts KiB
    return result;
}

} // namespace evaluation
