// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
//
// Stitches two overlapping photographs: the source is warped onto the target, and both are shown from a view between them.
#include <algorithm>
#include <iostream>
#include "common/json.hpp"
#include "common/program.hpp"
#include "common/synthetic_pair.hpp"
#include "evaluation/methods.hpp"

using namespace cv::gcpw;

namespace
{

const char* const KEYS =
    "{help h usage ? |           | this text }"
    "{@source        |           | photograph that is warped }"
    "{@target        |           | photograph that it is aligned to }"
    "{method         | gcpw      | gcpw, its special cases global, cpw, dfw, mfw, or a rival: apap, lsh_mfw, ros_mfw }"
    "{output         | pano.png  | the panorama }"
    "{dump           |           | folder for source.png, source_mask.png, target.png, target_mask.png, source_corrected.png, mesh.png and the alignment, model.yml.gz }"
    "{report         |           | JSON file with scores, timings and what happened }"
    "{blend          | multiband | average (the paper's plain mean) or multiband (seam and multi-band blender) }"
    "{view           |           | natural (seen from between both, little stretched) or target (the target keeps its frame and pixels); default natural, with --paper target }"
    "{render_source  |           | estimate on @source but render this file, which must have its size }"
    "{work_megapix   |           | resolution of the estimation, million pixels }"
    "{threads        | -1        | threads to use; -1 leaves it to OpenCV }"
    "{paper          |           | the paper's constants instead of the defaults }"
    "{set            |           | further parameters, name=value,name=value; see gcpw::Params }"
    "{synthetic      |           | write source.png and target.png of a synthetic scene into this folder and stop }";

/// Everything one run is asked to do.
struct Job
{
    std::string source;
    std::string target;
    std::string render_source;
    std::string output;
    std::string dump;
    std::string report;
    Blend blend = Blend::MULTIBAND;
    View view = View::NATURAL;
    Params params;
    const evaluation::PairMethod* method = nullptr;
};

Job parse(const cv::CommandLineParser& parser, int argc, const char* const* argv)
{
    Job job;
    job.source = parser.get<std::string>("@source");
    job.target = parser.get<std::string>("@target");
    if (job.source.empty() || job.target.empty())
        throw WrongUse("two photographs are needed: gcpw_pair SOURCE TARGET; --help lists the options");
    if (std::count_if(argv + 1, argv + argc, [](const char* argument) { return argument[0] != '-'; }) > 2)
        throw WrongUse("two photographs are stitched: gcpw_pair SOURCE TARGET; gcpw_stitch takes more");
    job.render_source = parser.get<std::string>("render_source");
    job.output = parser.get<std::string>("output");
    job.dump = parser.get<std::string>("dump");
    job.report = parser.get<std::string>("report");
    const std::string blend = parser.get<std::string>("blend");
    if (blend != "average" && blend != "multiband")
        throw WrongUse("unknown blend '" + blend + "'; there are average, multiband");
    job.blend = blend == "average" ? Blend::AVERAGE : Blend::MULTIBAND;
    const std::string view = parser.get<std::string>("view");
    if (!view.empty() && view != "natural" && view != "target")
        throw WrongUse("unknown view '" + view + "'; there are natural, target");
    job.view = view == "target" || (view.empty() && parser.has("paper")) ? View::TARGET : View::NATURAL;
    if (parser.has("paper"))
        job.params = Params::paper();
    const std::string method = parser.get<std::string>("method");
    job.method = evaluation::findPairMethod(method);
    if (!job.method)
        throw WrongUse("unknown method '" + method + "'; there are " + evaluation::pairMethodNames());
    if (parser.has("work_megapix"))
        job.params.workMegapix = parser.get<double>("work_megapix");
    if (!(job.params.workMegapix >= LEAST_MEGAPIX))
        throw WrongUse(cv::format("--work_megapix is million pixels, at least %g", LEAST_MEGAPIX));
    applySettings(parser.get<std::string>("set"), job.params);
    const int threads = parser.get<int>("threads");
    if (!parser.check())
    {
        parser.printErrors();
        throw WrongUse("--help lists the options");
    }
    if (threads >= 0)
        cv::setNumThreads(threads);
    job.params.check();
    std::vector<std::string> inputs = {job.source, job.target};
    if (!job.render_source.empty())
        inputs.push_back(job.render_source);
    checkOutputs(inputs, {job.output}, {job.report}, job.dump);
    return job;
}

void addEnergies(Json& json, const std::string& key, const std::vector<TermEnergy>& energies)
{
    json.beginObject(key);
    for (const TermEnergy& energy : energies)
        json.add(energy.name, energy.value);
    json.add("total", totalEnergy(energies));
    json.endObject();
}

void addScore(Json& json, const std::string& key, const Score& score)
{
    json.beginObject(key).add("ncc", score.ncc).add("zncc", score.zncc).endObject();
}

const char* stopName(StopReason reason)
{
    switch (reason)
    {
    case StopReason::ITERATION_LIMIT:
        return "iteration_limit";
    case StopReason::MESH_STABLE:
        return "mesh_stable";
    case StopReason::ENERGY_STABLE:
        return "energy_stable";
    case StopReason::NO_DESCENT:
        return "no_descent";
    case StopReason::SINGULAR:
        return "singular";
    case StopReason::CANCELLED:
        return "cancelled";
    }
    return "unknown";
}

/// @param before, after null where nothing was rendered
std::string reportText(const Report& report, const char* method, const Score* before, const Score* after, double render_ms)
{
    Json json;
    json.beginObject();
    json.add("status", nameOf(report.status)).add("message", report.message).add("method", method);
    json.add("points", report.pairs.empty() ? 0 : report.pairs[0].points);
    json.add("lines", report.pairs.empty() ? 0 : report.pairs[0].lines);
    json.add("folds", report.folds).add("max_displacement_px", report.max_displacement_px);
    json.add("gain_min", report.gain_min).add("gain_max", report.gain_max);
    json.beginArray("levels");
    for (const LevelReport& level : report.levels)
    {
        json.beginObject().add("scale", level.scale).add("iterations", level.iterations);
        json.add("stop", stopName(level.stop));
        addEnergies(json, "energy_start", level.start);
        addEnergies(json, "energy_end", level.end);
        json.endObject();
    }
    json.endArray();
    if (before && after)
    {
        json.beginObject("scores");
        addScore(json, "before", *before);
        addScore(json, "after", *after);
        json.endObject();
    }
    const Timings& t = report.timings_ms;
    json.beginObject("timings_ms").add("features", t.features).add("homography", t.homography).add("align", t.align);
    json.add("render", render_ms).add("total", t.total + render_ms).endObject();
    json.endObject();
    return json.text();
}

void dumpCanvas(const std::string& folder, const PairCanvas& canvas)
{
    makeFolder(folder);
    writeImage(folder + "/source.png", canvas.source);
    writeImage(folder + "/source_mask.png", canvas.source_mask);
    writeImage(folder + "/target.png", canvas.target);
    writeImage(folder + "/target_mask.png", canvas.target_mask);
    writeImage(folder + "/source_corrected.png", canvas.source_corrected);
    writeImage(folder + "/mesh.png", canvas.mesh);
}

int stitch(const Job& job)
{
    const cv::Mat source = readImage(job.source);
    const cv::Mat target = readImage(job.target);
    const cv::Mat shown = job.render_source.empty() ? source : readImage(job.render_source);
    if (shown.size() != source.size())
        throw WrongUse(job.render_source + " must have the size of " + job.source);
    const Progress progress = terminalProgress();
    const PairMatches matches = findPairMatches(source, target, job.params, progress);
    const Alignment alignment = job.method->align(source, target, matches, job.params, progress);
    const Report& report = alignment.report();
    if (report.status == Status::NO_ALIGNMENT)
    {
        endProgress();
        if (!job.report.empty())
            writeText(job.report, reportText(report, job.method->name, nullptr, nullptr, 0));
        std::cerr << "gcpw_pair: " << report.message << '\n';
        return EXIT_NO_ALIGNMENT;
    }
    if (progress)
        progress("render", 0);
    cv::TickMeter render;
    render.start();
    const PairCanvas canvas = renderPair(alignment, shown, target, job.view);
    const cv::Mat panorama = blendPair(canvas, job.blend);
    render.stop();
    // In the target's frame whatever the view: elsewhere pixels have another size, and the score another meaning.
    const Score after = scorePair(job.view == View::TARGET ? canvas : renderPair(alignment, shown, target));
    writeImage(job.output, panorama);
    if (!job.dump.empty())
    {
        dumpCanvas(job.dump, canvas);
        writeModel(job.dump + "/model.yml.gz", [&](const std::string& path) { alignment.save(path); });
    }
    if (!job.report.empty())
    {
        const Score before = scorePair(renderPair(alignment.rough(), shown, target));
        writeText(job.report, reportText(report, job.method->name, &before, &after, render.getTimeMilli()));
    }
    endProgress();
    if (!report.message.empty())
        std::cout << report.message << '\n';
    std::cout << job.output << ": " << panorama.cols << " x " << panorama.rows << ", misalignment zncc " << after.zncc
              << ", " << cvRound(report.timings_ms.total + render.getTimeMilli()) << " ms\n";
    return EXIT_STITCHED;
}

int writeSynthetic(const std::string& folder)
{
    cv::Mat source;
    cv::Mat target;
    makeSyntheticPair(source, target);
    makeFolder(folder);
    writeImage(folder + "/source.png", source);
    writeImage(folder + "/target.png", target);
    std::cout << folder << "/source.png and target.png written\n";
    return EXIT_STITCHED;
}

} // namespace

int main(int argc, char** argv)
{
    const std::string about = "Stitches two overlapping photographs with Generalized Content-Preserving Warps.\n"
                              "Exit code: 0 stitched, 1 no alignment found, 2 wrong use or a file that cannot be read or written.";
    return runProgram("gcpw_pair", argc, argv, KEYS, about, [&](const cv::CommandLineParser& parser)
    {
        return parser.has("synthetic") ? writeSynthetic(parser.get<std::string>("synthetic")) : stitch(parse(parser, argc, argv));
    });
}
