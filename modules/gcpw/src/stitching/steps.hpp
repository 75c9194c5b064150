// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#ifndef OPENCV_GCPW_STEPS_HPP
#define OPENCV_GCPW_STEPS_HPP

#include <algorithm>
#include <atomic>
#include <mutex>
#include <string>
#include "opencv2/gcpw/alignment.hpp"

namespace cv
{
namespace gcpw
{

/// Tells the caller how much of a stage is done, from any thread, and keeps in mind whether the answer was to stop.
class Steps
{
public:
    explicit Steps(const Progress& progress) : progress_(progress) {}

    /// So many steps of a stage are to come, which take it from one fraction to another.
    void begin(const char* stage, double from, double to, int count)
    {
        stage_ = stage;
        from_ = from;
        step_ = (to - from) / std::max(count, 1);
        done_ = 0;
        tell();
    }

    /// One more is done.
    void next()
    {
        const std::lock_guard<std::mutex> lock(mutex_);
        ++done_;
        tell();
    }

    bool cancelled() const { return cancelled_; }

private:
    void tell()
    {
        if (progress_ && !cancelled_)
            cancelled_ = !progress_(stage_, std::min(1.0, from_ + done_ * step_));
    }

    const Progress& progress_;
    std::mutex mutex_;
    std::atomic<bool> cancelled_{false};
    std::string stage_;
    double from_ = 0;
    double step_ = 0;
    int done_ = 0;
};

} // namespace gcpw
} // namespace cv

#endif
