// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
//
// Compares the methods on a folder of pairs, the paper's two experiments, and panoramas with those of OpenCV alone.
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <iostream>
#include <set>
#include <sstream>
#include <thread>
#include <unistd.h>
#include "common/program.hpp"
#include "common/write_file.hpp"
#include "evaluation/color_variation.hpp"
#include "evaluation/contact_sheet.hpp"
#include "evaluation/experiment.hpp"
#include "evaluation/external.hpp"
#include "evaluation/image_sets.hpp"
#include "evaluation/tables.hpp"

using evaluation::PairMethod;

namespace
{

const CommandLine::Texts TEXTS = {
    "gcpw_evaluate",
    "Compares the methods on pairs of photographs, as they are and with synthetic colour variation, and panoramas with "
    "OpenCV's.\n"
    "Exit code: 0 all runs done, 1 some runs had no result, 2 wrong use, 3 could not read or write a file.",
    "gcpw_evaluate --pairs=FOLDER [options]",
    {"gcpw_evaluate --pairs=PAIRS --out=OUT --inputs=1 --degrees=0", "a quick look",
     "gcpw_evaluate --sets=SETS --out=OUT", "panoramas"}};

/// Everything one run is asked to do.
struct Job
{
    evaluation::Experiment experiment;
    std::vector<std::string> options; ///< what the results depend on
    std::vector<evaluation::ImageSet> sets;
    std::vector<std::string> stitch_options; ///< for gcpw_stitch
    std::vector<PairMethod> externals;       ///< methods of other programs
    std::vector<std::string> complaints;     ///< of what was left out
    std::string write_inputs; ///< a folder, or empty: then the experiments are made
    bool fresh = false;
    bool sheets = true;
};

/// What the command line says.
struct Options
{
    std::string pairs;
    std::string sets;
    std::string out = "build/evaluation";
    std::string methods = "all";
    std::string degrees = "0..16";
    std::string write_inputs;
    std::string external;
    std::string settings;
    int inputs = evaluation::INPUTS;
    int workers = 0;
    double max_megapix = 0.48;
    bool fresh = false;
    bool no_sheets = false;
    bool paper = false;
};

void declare(CommandLine& line, Options& options)
{
    line.group("Photographs");
    line.text("--pairs", options.pairs, "FOLDER",
              "with a folder a pair, each with photographs 01.* (source) and 02.* (target)");
    line.text("--sets", options.sets, "FOLDER", "with a folder a panorama: stitched by OpenCV alone and with GCPW");
    line.number("--max_megapix", options.max_megapix, {LEAST_MEGAPIX, MOST_MEGAPIX, "million pixels"},
                "photographs are scaled down to this, million pixels");
    line.group("Experiment");
    line.text("--methods", options.methods, "NAMES",
              "comma-separated: global, apap, cpw, dfw, mfw, lsh_mfw, ros_mfw, gcpw");
    line.text("--external", options.external, "NAME:FOLDER,..",
              "results of other programs, to be compared: see doc/evaluation.md");
    line.text("--degrees", options.degrees, "NUMBERS", "of synthetic colour variation: 0..16, or 0,4,8");
    line.integer("--inputs", options.inputs, {1, evaluation::INPUTS},
                 "score each pair as the median over the first 1..5 inputs, a pixel apart; 1 for a quick look");
    line.integer("--workers", options.workers, {0, 256},
                 "inputs at a time, one thread each; 0 takes one for each core");
    line.flag("--paper", options.paper, "the paper's constants instead of the defaults");
    line.text("--set", options.settings, "NAME=VALUE,..", "further parameters; see gcpw::Params");
    line.group("Outputs");
    line.text("-o,--out", options.out, "FOLDER", "for tables and sheets; finished rows in it are kept");
    line.flag("--fresh", options.fresh, "forget the results in --out");
    line.flag("--no_sheets", options.no_sheets, "no contact sheets");
    line.text("--write_inputs", options.write_inputs, "FOLDER",
              "write the inputs of all pairs to it, PAIR/1/01.png and so on, and stop");
}

std::vector<std::string> split(const std::string& text)
{
    std::vector<std::string> items;
    std::istringstream list(text);
    for (std::string item; std::getline(list, item, ',');)
        items.push_back(item);
    return items;
}

std::vector<const PairMethod*> methodsOf(const std::string& text)
{
    std::vector<const PairMethod*> methods;
    const std::vector<std::string> names = split(text);
    for (const std::string& name : names)
        if (name != "all" && !evaluation::findPairMethod(name))
            throw WrongUse("unknown method '" + name + "'; there are all, " + evaluation::pairMethodNames());
    for (const PairMethod& method : evaluation::pairMethods())
        for (const std::string& name : names)
            if ((name == "all" || name == method.name) && (methods.empty() || methods.back() != &method))
                methods.push_back(&method);
    if (methods.empty())
        throw WrongUse("--methods names none; there are all, " + evaluation::pairMethodNames());
    return methods;
}

int degreeOf(const std::string& text)
{
    size_t end = 0;
    int degree = -1;
    if (!text.empty() && text.find_first_not_of("0123456789") == std::string::npos && text.size() < 4)
        degree = std::stoi(text, &end);
    if (degree < 0 || degree > evaluation::MAX_DEGREE)
        throw WrongUse("--degrees takes 0..16 or a list such as 0,4,8; got '" + text + "'");
    return degree;
}

std::vector<int> degreesOf(const std::string& text)
{
    std::set<int> degrees;
    for (const std::string& item : split(text))
    {
        const size_t dots = item.find("..");
        const int first = degreeOf(item.substr(0, dots));
        const int last = dots == std::string::npos ? first : degreeOf(item.substr(dots + 2));
        for (int degree = first; degree <= last; ++degree)
            degrees.insert(degree);
    }
    if (degrees.empty())
        throw WrongUse("--degrees names none; it takes 0..16 or a list such as 0,4,8");
    return std::vector<int>(degrees.begin(), degrees.end());
}

Job jobOf(const Options& options)
{
    Job job;
    evaluation::Experiment& experiment = job.experiment;
    if (options.pairs.empty() && options.sets.empty())
        throw WrongUse("photographs are needed: gcpw_evaluate --pairs=FOLDER or --sets=FOLDER; --help lists the options");
    if (options.pairs.empty() && !options.write_inputs.empty())
        throw WrongUse("--write_inputs is for pairs: gcpw_evaluate --pairs=FOLDER --write_inputs=FOLDER");
    if (!options.pairs.empty())
        experiment.pairs = evaluation::findPairs(options.pairs, job.complaints);
    if (!options.sets.empty())
        job.sets = evaluation::findSets(options.sets);
    experiment.folder = options.out;
    experiment.methods = methodsOf(options.methods);
    for (const std::string& external : split(options.external))
        job.externals.push_back(evaluation::externalMethod(external));
    experiment.degrees = degreesOf(options.degrees);
    experiment.inputs = options.inputs;
    experiment.max_megapix = options.max_megapix;
    experiment.workers =
        options.workers > 0 ? options.workers : std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
    job.write_inputs = options.write_inputs;
    job.fresh = options.fresh;
    job.sheets = !options.no_sheets;
    if (options.paper)
        experiment.params = cv::gcpw::Params::paper();
    applySettings(options.settings, experiment.params);
    if (!job.sets.empty() && options.paper)
        throw WrongUse("--paper is for pairs; gcpw_stitch takes --set");
    if (!options.settings.empty())
        job.stitch_options.push_back("--set=" + options.settings);
    job.options.push_back(cv::format("max_megapix=%.9g", experiment.max_megapix));
    for (const std::string& name : cv::gcpw::Params::names())
        if (name != "method")
            job.options.push_back(name + cv::format("=%.9g", experiment.params.get(name)));
    return job;
}

int writeInputs(const evaluation::Experiment& experiment, const std::string& folder)
{
    int code = EXIT_STITCHED;
    for (const evaluation::PairFiles& pair : experiment.pairs)
        for (int input = 1; input <= experiment.inputs; ++input)
        {
            cv::Mat source;
            cv::Mat target;
            try
            {
                source = evaluation::readInput(pair.source, experiment.max_megapix, input);
                target = evaluation::readInput(pair.target, experiment.max_megapix, input);
            }
            catch (const cv::Exception& error)
            {
                std::cerr << "gcpw_evaluate: " << pair.name << ": " << error.err << '\n';
                code = EXIT_NO_ANSWER;
                break;
            }
            const std::string place = folder + "/" + pair.name + "/" + std::to_string(input);
            makeFolder(place);
            writeImage(place + "/01.png", source);
            writeImage(place + "/02.png", target);
        }
    std::cout << folder << " written\n";
    return code;
}

void showProgress(int done, int total)
{
    if (!isatty(STDERR_FILENO))
        return;
    const int width = 40;
    const int full = total ? width * done / total : width;
    std::cerr << "\r[" << std::string(full, '#') << std::string(width - full, ' ') << "] " << done << " of " << total << " runs ";
    if (done == total)
        std::cerr << '\n';
    std::cerr.flush();
}

/// Returns whether the photographs of all pairs could be read.
bool writeSheets(const evaluation::Experiment& experiment, const evaluation::RunTable& rows)
{
    bool all = true;
    const std::string folder = experiment.folder + "/sheets";
    makeFolder(folder);
    for (const evaluation::PairFiles& pair : experiment.pairs)
    {
        cv::Mat sheet;
        try
        {
            sheet = evaluation::contactSheet(experiment, pair, rows);
        }
        catch (const cv::Exception& error)
        {
            std::cerr << "gcpw_evaluate: no sheet of " << pair.name << ": " << error.err << '\n';
            all = false;
        }
        if (!sheet.empty())
            writeImage(folder + "/" + pair.name + ".jpg", sheet);
    }
    std::cout << folder << " written\n";
    return all;
}

void complain(const std::vector<std::string>& complaints)
{
    for (const std::string& complaint : complaints)
        std::cerr << "gcpw_evaluate: " << complaint << '\n';
}

/// Without those of other programs that have no score at all: pairs without one of a method do not enter the means.
std::vector<const PairMethod*> measured(const std::vector<const PairMethod*>& methods, const evaluation::RunTable& rows)
{
    std::set<std::string> scored;
    for (const auto& row : rows)
        if (std::isfinite(row.second.zncc))
            scored.insert(row.first.method);
    std::vector<const PairMethod*> result;
    for (const PairMethod* method : methods)
        if (method->results.empty() || scored.count(method->name))
            result.push_back(method);
    return result;
}

int evaluatePairs(const Job& job)
{
    evaluation::Experiment experiment = job.experiment;
    for (const PairMethod& method : job.externals) // GCPW, which tables compare with the others, stays the last one
        experiment.methods.insert(experiment.methods.end() - 1, &method);
    evaluation::ResultsFile results(experiment.folder, job.options, job.fresh);
    const std::vector<std::string> complaints = evaluation::run(experiment, results, showProgress);
    complain(complaints);
    const std::string report = experiment.folder + "/report.md";
    const evaluation::RunTable rows = results.rows();
    writeText(report, evaluation::markdownPage(rows, measured(experiment.methods, rows), experiment.inputs));
    std::cout << report << " and results.csv written\n";
    bool whole = complaints.empty();
    if (job.sheets && experiment.degrees.front() == 0)
        whole = writeSheets(experiment, rows) && whole;
    return whole ? EXIT_STITCHED : EXIT_NO_ANSWER;
}

/// @param program path of gcpw_stitch
int evaluateSets(const Job& job, const std::string& program)
{
    const std::string report = job.experiment.folder + "/sets.md";
    const auto say = [](const std::string& set, const std::string& method)
    { std::cerr << "stitching " << set << (method == "none" ? " with OpenCV alone\n" : " with GCPW\n"); };
    std::vector<std::string> complaints;
    writeText(report, evaluation::stitchSets(job.sets, job.externals, program, job.stitch_options,
                                             job.experiment.folder, job.fresh, say, complaints));
    complain(complaints);
    std::cout << report << " and sets.csv written\n";
    return complaints.empty() ? EXIT_STITCHED : EXIT_NO_ANSWER;
}

/// The program of this name beside this one.
std::string siblingOf(const char* self, const std::string& name)
{
    std::error_code error;
    std::filesystem::path path = std::filesystem::read_symlink("/proc/self/exe", error);
    if (error)
        path = self;
    return (path.parent_path() / name).string();
}

} // namespace

int main(int argc, char** argv)
{
    CommandLine line(TEXTS);
    Options options;
    declare(line, options);
    return runProgram(line, argc, argv,
                      [&](const Console&)
                      {
        try
        {
            const Job job = jobOf(options);
            if (!job.write_inputs.empty())
                return writeInputs(job.experiment, job.write_inputs);
            cv::setNumThreads(1); // a worker is a thread: no matter how many there are, each run is the same
            complain(job.complaints);
            int code = job.complaints.empty() ? EXIT_STITCHED : EXIT_NO_ANSWER;
            if (!job.experiment.pairs.empty())
                code = std::max(code, evaluatePairs(job));
            if (!job.sets.empty())
                code = std::max(code, evaluateSets(job, siblingOf(argv[0], "gcpw_stitch")));
            return code;
        }
        catch (const cv::Exception& error) // no such folder, results of other options
        {
            throw WrongUse(error.err.empty() ? error.what() : error.err);
        }
    });
}
