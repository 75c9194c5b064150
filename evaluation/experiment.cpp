// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#include "evaluation/experiment.hpp"

#include <ctime>
#include <exception>
#include <limits>
#include <mutex>
#include <set>
#include <thread>
#include "evaluation/color_variation.hpp"
#include "evaluation/external.hpp"

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

/// One run of an input.
struct Task
{
    const PairMethod* method;
    int degree;
};

/// What a worker takes at a time: the runs that one input of a pair lacks.
struct Batch
{
    const PairFiles* pair;
    int input;
    std::vector<Task> tasks;
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

/// An input of a pair, and what its matches took.
struct Matched
{
    cv::Mat source;
    cv::Mat target;
    PairMatches matches;
    double match_ms = 0;
    std::vector<cv::Vec4f> segments; ///< of the source, see longSegments(), found when the first run needs them
    cv::Size segments_size;          ///< working pixels in which they were found
};

/// What a person sees of a run on the photographs as they are.
void addAppearance(const Alignment& alignment, const cv::gcpw::PairCanvas& canvas, Matched& input, RunResult& result)
{
    const cv::gcpw::AlignedImage& source = alignment.image(0);
    if (input.segments_size != source.work_size)
        input.segments = longSegments(input.source, source.work_size);
    input.segments_size = source.work_size;
    addMeshes(alignment, moves(source) ? bendsOf(source, input.segments) : std::vector<SegmentBend>(), result);
    addPictures(imagesOf(canvas), result);
}

std::string nameOf(const RunKey& key)
{
    return key.pair + ", " + key.method + cv::format(", degree %d, input %d: ", key.degree, key.input);
}

/// What the workers share.
class Crew
{
public:
    Crew(const Experiment& experiment, ResultsFile& results, const RunCallback& progress)
        : experiment_(experiment), results_(results), progress_(progress)
    {
        for (int input = 1; input <= experiment.inputs; ++input) // an interrupted experiment has the first of all pairs
            for (const PairFiles& pair : experiment.pairs)
            {
                Batch batch = {&pair, input, {}};
                for (const Task& task : tasksOf(experiment))
                    if (!task.method->results.empty() ||
                        !results.has({pair.name, task.method->name, task.degree, input}))
                        batch.tasks.push_back(task);
                total_ += static_cast<int>(batch.tasks.size());
                if (!batch.tasks.empty())
                    batches_.push_back(batch);
            }
    }

    /// Takes batch after batch until there are none; never throws.
    void work() noexcept
    {
        try
        {
            for (size_t index = take(); index < batches_.size(); index = take())
                runBatch(batches_[index]);
        }
        catch (...)
        {
            const std::lock_guard<std::mutex> lock(mutex_);
            next_ = batches_.size(); // no worker begins another
            if (!error_)
                error_ = std::current_exception();
        }
    }

    std::vector<std::string> finish()
    {
        if (error_)
            std::rethrow_exception(error_);
        return std::vector<std::string>(complaints_.begin(), complaints_.end());
    }

private:
    size_t take()
    {
        const std::lock_guard<std::mutex> lock(mutex_);
        return next_ < batches_.size() ? next_++ : next_;
    }

    void runBatch(const Batch& batch)
    {
        Matched input;
        try
        {
            input = readAndMatch(batch);
        }
        catch (const cv::Exception& error)
        {
            complain(batch.pair->name + ": " + error.err);
            for (size_t i = 0; i < batch.tasks.size(); ++i)
                countRun();
            return;
        }
        for (const Task& task : batch.tasks)
        {
            const RunKey key = {batch.pair->name, task.method->name, task.degree, batch.input};
            RunResult result;
            try
            {
                result = task.method->results.empty() ? runTask(input, task, key) : readTask(input, *task.method, key);
            }
            catch (const cv::Exception& error)
            {
                result.status = "failed";
                result.ncc = result.zncc = std::numeric_limits<double>::quiet_NaN();
                complain(nameOf(key) + error.err);
            }
            result.match_ms = input.match_ms;
            results_.append(key, result);
            countRun();
        }
    }

    Matched readAndMatch(const Batch& batch) const
    {
        Matched input;
        input.source = readInput(batch.pair->source, experiment_.max_megapix, batch.input);
        input.target = readInput(batch.pair->target, experiment_.max_megapix, batch.input);
        const double start = threadMilliseconds();
        input.matches = cv::gcpw::findPairMatches(input.source, input.target, experiment_.params);
        input.match_ms = threadMilliseconds() - start;
        return input;
    }

    RunResult runTask(Matched& input, const Task& task, const RunKey& key)
    {
        RunResult result;
        const cv::Mat recolored = varyColors(input.source, task.degree);
        const double start = threadMilliseconds();
        const Alignment alignment =
            task.method->align(recolored, input.target, input.matches, experiment_.params, cv::gcpw::Progress());
        result.align_ms = threadMilliseconds() - start;
        if (alignment.imageCount() == 0)
        {
            result.status = "no_alignment";
            result.ncc = result.zncc = std::numeric_limits<double>::quiet_NaN();
            complain(nameOf(key) + alignment.report().message);
            return result;
        }
        result.status = alignment.ok() ? "ok" : "rough";
        result.folds = alignment.report().folds;
        const cv::gcpw::PairCanvas canvas = cv::gcpw::renderPair(alignment, input.source, input.target);
        const cv::gcpw::Score score = cv::gcpw::scorePair(canvas);
        result.ncc = score.ncc;
        result.zncc = score.zncc;
        if (task.degree == 0)
            addAppearance(alignment, canvas, input, result);
        if (task.degree == 0 && key.input == INPUT_GIVEN)
            alignment.save(alignmentPath(experiment_.folder, key.pair, key.method));
        return result;
    }

    /// The same of what another program found.
    RunResult readTask(Matched& input, const PairMethod& method, const RunKey& key) const
    {
        RunResult result;
        const ExternalResult found =
            readExternal(method, key.pair, key.input, input.source, input.target, input.matches.target_from_source);
        result.ncc = result.zncc = std::numeric_limits<double>::quiet_NaN();
        if (found.canvas.source.empty())
        {
            result.status = "picture";
            return result;
        }
        const cv::gcpw::Score score = cv::gcpw::scorePair(found.canvas);
        result.ncc = score.ncc;
        result.zncc = score.zncc;
        if (found.alignment.imageCount() > 0)
        {
            result.folds = found.alignment.report().folds;
            addAppearance(found.alignment, found.canvas, input, result);
        }
        else
            addPictures(imagesOf(found.canvas), result);
        return result;
    }

    void complain(const std::string& message)
    {
        const std::lock_guard<std::mutex> lock(mutex_);
        complaints_.insert(message);
    }

    void countRun()
    {
        const std::lock_guard<std::mutex> lock(mutex_);
        ++done_;
        if (progress_)
            progress_(done_, total_);
    }

    const Experiment& experiment_;
    ResultsFile& results_;
    const RunCallback& progress_;
    std::vector<Batch> batches_;
    std::mutex mutex_; ///< of everything below
    size_t next_ = 0;
    int done_ = 0;
    int total_ = 0;
    std::set<std::string> complaints_; ///< what is wrong with a pair is said once, not for each input
    std::exception_ptr error_;
};

} // namespace

std::vector<std::string> run(const Experiment& experiment, ResultsFile& results, const RunCallback& progress)
{
    CV_CheckGE(experiment.workers, 1, "an experiment needs a worker or more");
    CV_Check(experiment.inputs, experiment.inputs >= 1 && experiment.inputs <= INPUTS, "an experiment is on 1 to 5 inputs");
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
