// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#include "pair/run.hpp"

#include "common/crop.hpp"
#include "common/exit_code.hpp"
#include "common/progress_line.hpp"
#include "common/read_all.hpp"
#include "common/synthetic_pair.hpp"
#include "common/write_file.hpp"
#include "pair/report.hpp"
#include "report/pair_page.hpp"
#include "report/report.hpp"

using namespace cv::gcpw;

namespace
{

// Stages of the work, with the shares of the time that they take of photographs of 2 Mpx.
const char* const READING = "reading";
const char* const MATCHING = "matching";
const char* const ALIGNING = "aligning";
const char* const RENDERING = "rendering";
const std::vector<ProgressLine::Stage> STAGES = {{READING, 1}, {MATCHING, 4}, {ALIGNING, 6}, {RENDERING, 5}};
// What the module calls its own.
const std::vector<ProgressLine::Stage> MATCHING_PARTS = {{"features", 1}, {"homography", 2}};
const std::vector<ProgressLine::Stage> ALIGNING_PARTS = {{"align", 1}};

int writeSynthetic(const std::string& folder, const Console& console)
{
    cv::Mat source;
    cv::Mat target;
    makeSyntheticPair(source, target);
    makeFolder(folder);
    writeImage(folder + "/source.png", source);
    writeImage(folder + "/target.png", target);
    console.tell(folder + "/source.png and target.png written");
    return EXIT_STITCHED;
}

void dumpCanvas(const std::string& folder, const PairCanvas& canvas, const Alignment& alignment)
{
    makeFolder(folder);
    writeImage(folder + "/source.png", canvas.source);
    writeImage(folder + "/source_mask.png", canvas.source_mask);
    writeImage(folder + "/target.png", canvas.target);
    writeImage(folder + "/target_mask.png", canvas.target_mask);
    writeImage(folder + "/source_corrected.png", canvas.source_corrected);
    writeImage(folder + "/mesh.png", canvas.mesh);
    writeModel(folder + "/model.yml.gz", [&](const std::string& path) { alignment.save(path); });
}

int stitch(const PairJob& job, const Console& console)
{
    ProgressLine progress(STAGES, console.loudness() != Console::Loudness::QUIET);
    progress.begin(READING);
    const std::vector<Photograph> photographs = readAll({job.source, job.target}, false, console, progress);
    // The estimate is made on 8 bits, the picture of all that its format takes.
    const cv::Mat source = toBytes(photographs[0].image);
    const cv::Mat target = toBytes(photographs[1].image);
    const cv::Mat whole = job.render_source.empty() ? photographs[0].image : readImage(job.render_source);
    const bool deep = keepsDeepPixels(job.output);
    const cv::Mat shown = deep ? whole : toBytes(whole);
    const cv::Mat shown_target = deep ? photographs[1].image : target;
    if (shown.size() != source.size())
        throw WrongUse(cv::format("%s is %d x %d px and must have the size of %s, %d x %d px",
                                  job.render_source.c_str(), shown.cols, shown.rows, job.source.c_str(), source.cols,
                                  source.rows));
    progress.begin(MATCHING);
    const PairMatches matches = findPairMatches(source, target, job.params, progress.callback(MATCHING_PARTS));
    progress.begin(ALIGNING);
    const Alignment alignment =
        job.method->align(source, target, matches, job.params, progress.callback(ALIGNING_PARTS));
    const Report& report = alignment.report();
    report::PairRun run;
    run.program = "gcpw_pair";
    run.method = job.method->label;
    run.paths = {job.source, job.target};
    run.source = shown;
    run.target = shown_target;
    run.alignment = alignment;
    run.view = job.view;
    run.blend = job.blend;
    if (report.status == Status::NO_ALIGNMENT)
    {
        ProgressLine::erase();
        if (!job.report.empty())
            report::write(job.report, reportText(report, job.method->name, nullptr, nullptr, 0),
                          [&] { return pageOf(run); });
        console.warn(report.message);
        return EXIT_NO_ANSWER;
    }
    progress.begin(RENDERING);
    cv::TickMeter render;
    render.start();
    const PairCanvas canvas = renderPair(alignment, shown, shown_target, job.view);
    progress.show(0.3);
    cv::Mat panorama = blendPair(canvas, job.blend);
    run.canvas = canvas;
    run.panorama = panorama;
    render.stop();
    progress.show(0.7);
    // In the target's frame whatever the view: elsewhere pixels have another size, and the score another meaning.
    const Score after = scorePair(job.view == View::TARGET ? canvas : renderPair(alignment, shown, shown_target));
    progress.show(0.9);
    const cv::Rect inner = job.crop == "auto" ? largestRectangle(canvas.source_mask | canvas.target_mask) : cv::Rect();
    if (!inner.empty())
        panorama = panorama(inner);
    run.crop = inner;
    writePicture(job.output, panorama, job.format, sharedMetadata(photographs, {1, 0}, console));
    if (!job.dump.empty())
        dumpCanvas(job.dump, canvas, alignment);
    if (!job.report.empty())
    {
        const Score before = scorePair(renderPair(alignment.rough(), shown, shown_target));
        run.zncc = {before.zncc, after.zncc};
        run.render_ms = render.getTimeMilli();
        report::write(job.report, reportText(report, job.method->name, &before, &after, run.render_ms),
                      [&] { return pageOf(run); });
    }
    ProgressLine::erase();
    if (!report.message.empty())
        console.tell(report.message);
    console.tell(cv::format("%s: %d x %d, misalignment zncc %g, %d ms", job.output.c_str(), panorama.cols,
                            panorama.rows, after.zncc, cvRound(report.timings_ms.total + render.getTimeMilli())));
    return EXIT_STITCHED;
}

} // namespace

int runPair(const PairJob& job, const Console& console)
{
    return job.synthetic.empty() ? stitch(job, console) : writeSynthetic(job.synthetic, console);
}
