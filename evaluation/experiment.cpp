// Part of the GCPW module for OpenCV. Licence: Apache-2.0 (see LICENSE).
#include "evaluation/experiment.hpp"

#include <algorithm>
#include <ctime>
#include <exception>
#include <limits>
#include <mutex>
#include <thread>
#include "evaluation/color_variation.hpp"

namespace evaluation
{

namespace
{

using cv::gcpw::Alignment;
using cv::gcpw::PairMatches;

/// Processor time of this thread, milliseconds: other programs on the machine hardly change it.
double threadMilliseconds()
{
    timespec now = {};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
    return 1e3 * static_cast<double>(now.tv_sec) + 1e-6 * static_cast<double>(now.tv_nsec);
}

/// One run of a pair.
struct Task
{
    const PairMethod* method;
    int degree;
};

std::vector<Task> tasksOf(const Experiment& experiment)
{
    std::vector<Task> tasks;
    for (const PairMethod* method : experiment.methods)
        for (int degree : experiment.degrees)
            if (degree == 0 || method->looks_at_pixels)
                tasks.push_back({method, degree});
    return tasks;
}

/// What the workers share.
class Crew
{
public:
    Crew(const Experiment& experiment, ResultsFile& results, const RunCallback& progress)
        : experiment_(experiment), results_(results), progress_(progress)
    {
        for (const PairFiles& pair : experiment.pairs)
        {
            std::vector<Task> missing;
            for (const Task& task : tasksOf(experiment))
                if (!results.has({pair.name, task.method->name, task.degree}))
                    missing.push_back(task);
            total_ += static_cast<int>(missing.size());
            missing_.push_back(missing);
        }
    }

    /// Takes pair after pair until there are none; never throws.
    void work() noexcept
    {
        try
        {
            for (size_t index = take(); index < missing_.size(); index = take())
                if (!missing_[index].empty())
                    runPair(experiment_.pairs[index], missing_[index]);
        }
        catch (...)
        {
            const std::lock_guard<std::mutex> lock(mutex_);
            next_ = missing_.size(); // nobody begins another
            if (!error_)
                error_ = std::current_exception();
        }
    }

    std::vector<std::string> finish()
    {
        if (error_)
            std::rethrow_exception(error_);
        std::sort(complaints_.begin(), complaints_.end());
        return complaints_;
    }

private:
    size_t take()
    {
        const std::lock_guard<std::mutex> lock(mutex_);
        return next_ < missing_.size() ? next_++ : next_;
    }

    void runPair(const PairFiles& pair, const std::vector<Task>& tasks)
    {
        const cv::Mat source = readCapped(pair.source, experiment_.max_megapix);
        const cv::Mat target = readCapped(pair.target, experiment_.max_megapix);
        const double start = threadMilliseconds();
        const PairMatches matches = cv::gcpw::findPairMatches(source, target, experiment_.params);
        const double match_ms = threadMilliseconds() - start;
        for (const Task& task : tasks)
        {
            const RunKey key = {pair.name, task.method->name, task.degree};
            RunResult result;
            try
            {
                result = runTask(source, target, matches, task, key);
            }
            catch (const cv::Exception& error)
            {
                result.status = "failed";
                result.ncc = result.zncc = std::numeric_limits<double>::quiet_NaN();
                complain(key, error.err);
            }
            result.match_ms = match_ms;
            results_.append(key, result);
            const std::lock_guard<std::mutex> lock(mutex_);
            ++done_;
            if (progress_)
                progress_(done_, total_);
        }
    }

    RunResult runTask(const cv::Mat& source, const cv::Mat& target, const PairMatches& matches, const Task& task,
                      const RunKey& key)
    {
        RunResult result;
        const cv::Mat recolored = varyColors(source, task.degree);
        const double start = threadMilliseconds();
        const Alignment alignment = task.method->align(recolored, target, matches, experiment_.params, cv::gcpw::Progress());
        result.align_ms = threadMilliseconds() - start;
        if (alignment.imageCount() == 0)
        {
            result.status = "no_alignment";
            result.ncc = result.zncc = std::numeric_limits<double>::quiet_NaN();
            complain(key, alignment.report().message);
            return result;
        }
        result.status = alignment.ok() ? "ok" : "rough";
        result.folds = alignment.report().folds;
        const cv::gcpw::Score score = cv::gcpw::scorePair(cv::gcpw::renderPair(alignment, source, target));
        result.ncc = score.ncc;
        result.zncc = score.zncc;
        if (task.degree == 0)
            alignment.save(alignmentPath(experiment_.folder, key.pair, key.method));
        return result;
    }

    void complain(const RunKey& key, const std::string& message)
    {
        const std::lock_guard<std::mutex> lock(mutex_);
        complaints_.push_back(key.pair + ", " + key.method + cv::format(", degree %d: ", key.degree) + message);
    }

    const Experiment& experiment_;
    ResultsFile& results_;
    const RunCallback& progress_;
    std::vector<std::vector<Task>> missing_; ///< of each pair
    std::mutex mutex_;                       ///< of everything below
    size_t next_ = 0;
    int done_ = 0;
    int total_ = 0;
    std::vector<std::string> complaints_;
    std::exception_ptr error_;
};

} // namespace

std::vector<std::string> run(const Experiment& experiment, ResultsFile& results, const RunCallback& progress)
{
    CV_CheckGE(experiment.workers, 1, "an experiment needs a worker or more");
    makeFolder(experiment.folder + "/alignments");
    Crew crew(experiment, results, progress);
    std::vector<std::thread> threads;
    for (int i = 1; i < experiment.workers; ++i)
        threads.emplace_back([&crew] { crew.work(); });
    crew.work();
    for (std::thread& thread : threads)
        thread.join();
    const std::vector<std::string> complaints = crew.finish();
    results.sort();
    return complaints;
}

std::string alignmentPath(const std::string& folder, const std::string& pair, const std::string& method)
{
    return folder + "/alignments/" + pair + "-" + method + ".yml.gz";
}

} // namespace evaluation
