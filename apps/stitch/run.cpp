// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#include "stitch/run.hpp"

#include <algorithm>
#include <numeric>
#include "common/crop.hpp"
#include "common/exit_code.hpp"
#include "common/paths.hpp"
#include "common/read_all.hpp"
#include "common/write_file.hpp"
#include "report/report.hpp"
#include "stitch/compose.hpp"
#include "stitch/frames.hpp"
#include "stitch/join_parts.hpp"
#include "stitch/model.hpp"
#include "stitch/page.hpp"
#include "stitch/report.hpp"
#include "stitch/run_tiled.hpp"
#include "stitch/stand_up.hpp"
#include "stitch/steps.hpp"
#include "stitch/two_photographs.hpp"

namespace
{

/// Shares of the time that stages take, of five photographs of 4 Mpx on two cores.
std::vector<ProgressLine::Stage> stagesOf(const StitchJob& job)
{
    if (!job.load_model.empty())
        return {{READING, 2}, {SEAMS, 3}, {COMPOSING, 5}};
    return {{READING, 1}, {MATCHING, 4}, {ALIGNING, job.gcpw ? 6.0 : 0.0}, {SEAMS, 2}, {COMPOSING, 3}};
}

/// Milliseconds since it was last asked.
class Laps
{
public:
    Laps() { clock_.start(); }

    double next()
    {
        clock_.stop();
        const double ms = clock_.getTimeMilli();
        clock_.reset();
        clock_.start();
        return ms;
    }

private:
    cv::TickMeter clock_;
};

bool isDeep(const std::vector<Photograph>& photographs)
{
    return std::any_of(photographs.begin(), photographs.end(),
                       [](const Photograph& one) { return one.image.depth() == CV_16U; });
}

/// What of the picture is written.
cv::Mat cropped(const StitchJob& job, const Console& console, Composition& composition)
{
    const cv::Rect inner = job.crop == "auto" ? largestRectangle(composition.shown) : cv::Rect();
    composition.crop = inner;
    if (inner.empty())
        return composition.picture;
    console.detail(cv::format("cropped from %d x %d to %d x %d px", composition.picture.cols, composition.picture.rows,
                              inner.width, inner.height));
    return composition.picture(inner);
}

/// One panorama and what belongs to it.
class Panorama
{
public:
    /// @param photographs of job.paths, those that could be read
    Panorama(const StitchJob& job, const std::vector<Photograph>& photographs, ProgressLine& progress,
             const Console& console)
        : job_(job), photographs_(photographs), progress_(progress), console_(console)
    {
    }

    /// Makes and writes it. @return whether there is one; trouble() says why not
    bool make(double read_ms)
    {
        stages_.read = read_ms;
        MatchLog log(static_cast<int>(photographs_.size()));
        Layout layout = layOut(job_, photographs_, log, progress_);
        writeGraph(job_, photographs_, log);
        Composition composition;
        stages_.cameras = laps_.next();
        if (layout.ok())
            composition = composed(layout);
        else if (mayBePair() && stitchTwo(job_, photographs_, layout, composition))
            layout.trouble.clear();
        stages_.compose = laps_.next();
        trouble_ = layout.trouble;
        kept_ = layout.component;
        const cv::Mat picture = layout.ok() ? cropped(job_, console_, composition) : cv::Mat();
        ProgressLine::erase();
        std::vector<std::string> paths;
        for (const Photograph& photograph : photographs_)
            paths.push_back(photograph.path);
        if (!job_.report.empty())
            report::write(job_.report, reportText(job_, paths, layout, stages_, picture.size()),
                          [&] { return pageOf(job_, photographs_, layout, composition, seams_, stages_); });
        tellDecisions(layout, console_);
        if (!layout.ok())
            return false;
        write(layout, picture);
        return true;
    }

    const std::string& trouble() const { return trouble_; }
    const std::vector<int>& kept() const { return kept_; } ///< photographs in the picture

private:
    /// What neither cameras nor a model are asked of.
    bool mayBePair() const
    {
        return photographs_.size() == 2 && job_.gcpw && job_.setup.mode == "auto" && job_.save_model.empty() &&
               job_.dump.empty() && job_.timelapse.empty();
    }

    Composition composed(Layout& layout)
    {
        const bool deep = isDeep(photographs_) && keepsDeepPixels(job_.output);
        TimeLapse frames(job_, layout);
        std::function<void(size_t, const Warping&, const Warping::Warped&)> on_warped;
        if (!job_.timelapse.empty())
            on_warped = [&frames](size_t k, const Warping& warping, const Warping::Warped& warped)
            { frames.write(k, warping, warped); };
        seams_ = recordSeams(layout);
        Composition composition = compose(job_, photographs_, layout, deep, progress_, on_warped);
        if (layout.turned)
        {
            composition.turns = turnsToStand(photographs_[0], layout.decisions);
            composition.picture = turned(composition.picture, composition.turns);
            composition.shown = turned(composition.shown, composition.turns);
        }
        return composition;
    }

    void write(const Layout& layout, const cv::Mat& picture) const
    {
        if (!layout.rig.alignment.report().message.empty())
            console_.tell(layout.rig.alignment.report().message);
        writePicture(job_.output, picture, job_.format, sharedMetadata(photographs_, layout.component, console_));
        if (!job_.save_model.empty())
            saveModel(layout, photographs_, job_.save_model);
        if (!job_.dump.empty())
            dumpWarped(job_, photographs_, layout);
        console_.tell(cv::format("%s: %d x %d of %zu images, %d ms", job_.output.c_str(), picture.cols, picture.rows,
                                 layout.component.size(), cvRound(stages_.total())));
        console_.detail(cv::format("reading took %.0f ms, cameras and alignment %.0f ms, composing %.0f ms",
                                   stages_.read, stages_.cameras, stages_.compose));
    }

    const StitchJob& job_;
    const std::vector<Photograph>& photographs_;
    ProgressLine& progress_;
    const Console& console_;
    Laps laps_;
    Stages stages_;
    cv::Ptr<report::RecordedSeams> seams_; ///< null before, and where two photographs are stitched as a pair
    std::string trouble_;
    std::vector<int> kept_;
};

std::vector<Photograph> without(const std::vector<Photograph>& photographs, const std::vector<int>& taken)
{
    std::vector<Photograph> rest;
    for (size_t i = 0; i < photographs.size(); ++i)
        if (std::find(taken.begin(), taken.end(), static_cast<int>(i)) == taken.end())
            rest.push_back(photographs[i]);
    return rest;
}

} // namespace

int runStitch(const StitchJob& job, const Console& console)
{
    if (job.join)
    {
        joinParts(job, console);
        return EXIT_STITCHED;
    }
    if (isTiled(job))
        return runTiled(job, console);
    ProgressLine progress(stagesOf(job), console.loudness() != Console::Loudness::QUIET);
    progress.begin(READING);
    Laps laps;
    const std::vector<Photograph> photographs = readAll(job.paths, job.skip_bad, console, progress);
    requireAllOfModel(job, photographs);
    Panorama largest(job, photographs, progress, console);
    if (!largest.make(laps.next()))
    {
        console.warn(largest.trouble());
        return EXIT_NO_ANSWER;
    }
    std::vector<Photograph> rest = without(photographs, largest.kept());
    const bool go_on = job.panoramas == "all" && job.load_model.empty() && !isDevice(job.output);
    for (int number = 2; go_on && rest.size() >= 2; ++number)
    {
        const StitchJob further = job.further(number);
        Panorama next(further, rest, progress, console);
        if (!next.make(0))
            break;
        rest = without(rest, next.kept());
    }
    for (const Photograph& photograph : rest)
        tellDropped(photograph.path, console);
    return EXIT_STITCHED;
}
