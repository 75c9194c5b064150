// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#include "common/progress_line.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <unistd.h>

namespace
{

const double TOO_EARLY = 0.05; ///< of the work, and
const double TOO_SHORT = 1;    ///< s: before, nothing can be said about the time left

size_t indexOf(const std::vector<ProgressLine::Stage>& stages, const std::string& name)
{
    const auto found = std::find_if(stages.begin(), stages.end(),
                                    [&](const ProgressLine::Stage& stage) { return stage.name == name; });
    return static_cast<size_t>(found - stages.begin());
}

} // namespace

ProgressLine::ProgressLine(const std::vector<Stage>& stages, bool shown)
    : stages_(stages), shown_(shown && isatty(STDERR_FILENO) != 0), start_(std::chrono::steady_clock::now())
{
}

void ProgressLine::begin(const std::string& stage)
{
    const size_t index = indexOf(stages_, stage);
    if (index == stages_.size())
        return;
    {
        const std::lock_guard<std::mutex> lock(mutex_);
        present_ = index;
        fraction_ = 0;
    }
    show(0);
}

void ProgressLine::show(double fraction)
{
    if (!shown_)
        return;
    const std::lock_guard<std::mutex> lock(mutex_);
    fraction_ = std::max(fraction_, std::min(fraction, 1.0)); // threads may come late
    const double done = doneOf(stages_, present_, fraction_);
    const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
    std::fprintf(stderr, "\r%-22s %3.0f %%  %-14s", stages_[present_].name.c_str(), 100 * done,
                 timeLeft(done, seconds).c_str());
    std::fflush(stderr);
}

cv::gcpw::Progress ProgressLine::callback(const std::vector<Stage>& parts)
{
    if (!shown_)
        return {};
    return [this, parts](const std::string& part, double fraction)
    {
        const size_t index = indexOf(parts, part);
        if (index < parts.size())
            show(doneOf(parts, index, fraction));
        return true;
        };
}

double ProgressLine::doneOf(const std::vector<Stage>& stages, size_t present, double fraction)
{
    double before = 0;
    double whole = 0;
    for (size_t i = 0; i < stages.size(); ++i)
    {
        whole += stages[i].share;
        before += i < present ? stages[i].share : 0;
    }
    return (before + fraction * stages[present].share) / whole;
}

void ProgressLine::erase()
{
    if (isatty(STDERR_FILENO) != 0)
        std::fprintf(stderr, "\r%44s\r", "");
}

std::string ProgressLine::timeLeft(double done, double seconds)
{
    if (!(done >= TOO_EARLY) || !(seconds >= TOO_SHORT))
        return {};
    const long left = std::lround(seconds * (1 - std::min(done, 1.0)) / done);
    return cv::format("%ld:%02ld left", left / 60, left % 60);
}
