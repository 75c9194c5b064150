// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
/** @file
Linked into the programs of the tsan preset: cv::parallel_for_ on threads that the thread sanitizer sees.

OpenCV's own threads (TBB, in Debian) are not instrumented. The sanitizer sees neither how work is handed to them nor how its
end is awaited, takes both for races, and suppressing those reports hides true races in loop bodies. Here each loop starts its
threads and joins them, and no report of them has to be suppressed. Needs OpenCV >= 4.5.2. */
#include <opencv2/core/parallel/parallel_backend.hpp>

#include <memory>
#include <thread>
#include <vector>

namespace
{

const int THREADS = 4; ///< also where there are fewer cores

thread_local int current_thread = 0;

class VisibleThreads : public cv::parallel::ParallelForAPI
{
public:
    /// Task i always runs on thread i mod n: a shared counter would order what nothing else orders.
    void parallel_for(int tasks, FN_parallel_for_body_cb_t body, void* data) override
    {
        const int count = count_;
        const auto work = [=](int thread)
        {
            current_thread = thread;
            for (int i = thread; i < tasks; i += count)
                body(i, i + 1, data);
            current_thread = 0;
        };
        std::vector<std::thread> others;
        for (int thread = 1; thread < count && thread < tasks; ++thread)
            others.emplace_back(work, thread);
        work(0);
        for (std::thread& other : others)
            other.join();
    }

    int getThreadNum() const override { return current_thread; }
    int getNumThreads() const override { return count_; }

    /// A negative count asks for the default, as in cv::setNumThreads().
    int setNumThreads(int count) override
    {
        const int before = count_;
        count_ = count > 0 ? count : THREADS;
        return before;
    }

    const char* getName() const override { return "visible_threads"; }

private:
    int count_ = THREADS;
};

const bool installed = (cv::parallel::setParallelForBackend(std::make_shared<VisibleThreads>()), true);

} // namespace
