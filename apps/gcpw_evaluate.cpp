// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
//
// Compares the methods on a folder of pairs, the paper's two experiments, and panoramas with those of OpenCV alone.
#include <filesystem>
#include <iostream>
#include <set>
#include <sstream>
#include <thread>
#include <unistd.h>
#include "common/program.hpp"
#include "evaluation/color_variation.hpp"
#include "evaluation/contact_sheet.hpp"
#include "evaluation/experiment.hpp"
#include "evaluation/image_sets.hpp"
#include "evaluation/tables.hpp"

using evaluation::PairMethod;

namespace
{

const char* const KEYS =
    "{help h usage ? |                  | this text }"
    "{pairs          |                  | folder with a folder a pair, each with photographs 01.* (source) and 02.* (target) }"
    "{sets           |                  | folder with a folder a panorama: stitched by OpenCV alone and with GCPW }"
    "{out            | build/evaluation | folder for tables and sheets; finished rows in it are kept }"
    "{methods        | all              | comma-separated: global, apap, cpw, dfw, mfw, lsh_mfw, ros_mfw, gcpw }"
    "{degrees        | 0..16            | of synthetic colour variation: 0..16, or 0,4,8 }"
    "{inputs         | 5                | score each pair as the median over the first 1..5 inputs, a pixel apart; 1 for a quick look }"
    "{max_megapix    | 0.48             | photographs are scaled down to this, million pixels }"
    "{write_inputs   |                  | write the inputs of all pairs to this folder, PAIR/1/01.png and so on, and stop }"
    "{workers        | 0                | inputs at a time, one thread each; 0 takes one for each core }"
    "{fresh          |                  | forget the results in --out }"
    "{no_sheets      |                  | no contact sheets }"
    "{paper          |                  | the paper's constants instead of the defaults }"
    "{set            |                  | further parameters, name=value,name=value; see gcpw::Params }";

/// Everything one run is asked to do.
struct Job
{
    evaluation::Experiment experiment;
    std::vector<std::string> options; ///< what the results depend on
    std::vector<evaluation::ImageSet> sets;
    std::vector<std::string> stitch_options; ///< for gcpw_stitch
    std::string write_inputs; ///< a folder, or empty: then the experiments are made
    bool fresh = false;
    bool sheets = true;
};

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

Job parse(const cv::CommandLineParser& parser)
{
    Job job;
    evaluation::Experiment& experiment = job.experiment;
    const std::string pairs = parser.get<std::string>("pairs");
    const std::string sets = parser.get<std::string>("sets");
    if (pairs.empty() && sets.empty())
        throw WrongUse("photographs are needed: gcpw_evaluate --pairs=FOLDER or --sets=FOLDER; --help lists the options");
    if (pairs.empty() && parser.has("write_inputs"))
        throw WrongUse("--write_inputs is for pairs: gcpw_evaluate --pairs=FOLDER --write_inputs=FOLDER");
    if (!pairs.empty())
        experiment.pairs = evaluation::findPairs(pairs);
    if (!sets.empty())
        job.sets = evaluation::findSets(sets);
    experiment.folder = parser.get<std::string>("out");
    experiment.methods = methodsOf(parser.get<std::string>("methods"));
    experiment.degrees = degreesOf(parser.get<std::string>("degrees"));
    experiment.inputs = parser.get<int>("inputs");
    experiment.max_megapix = parser.get<double>("max_megapix");
    experiment.workers = parser.get<int>("workers");
    job.write_inputs = parser.get<std::string>("write_inputs");
    job.fresh = parser.has("fresh");
    job.sheets = !parser.has("no_sheets");
    if (parser.has("paper"))
        experiment.params = cv::gcpw::Params::paper();
    const std::string settings = parser.get<std::string>("set");
    applySettings(settings, experiment.params);
    if (!job.sets.empty() && parser.has("paper"))
        throw WrongUse("--paper is for pairs; gcpw_stitch takes --set");
    if (!settings.empty())
        job.stitch_options.push_back("--set=" + settings);
    if (!parser.check())
    {
        parser.printErrors();
        throw WrongUse("--help lists the options");
    }
    if (!(experiment.max_megapix > 0))
        throw WrongUse("--max_megapix is million pixels, more than 0");
    if (experiment.inputs < 1 || experiment.inputs > evaluation::INPUTS)
        throw WrongUse("--inputs lies in 1..5, got " + std::to_string(experiment.inputs));
    if (experiment.workers < 0 || experiment.workers > 256)
        throw WrongUse("--workers lies in 0..256, got " + std::to_string(experiment.workers));
    if (experiment.workers == 0)
        experiment.workers = std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
    experiment.params.check();
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
                code = EXIT_NO_ALIGNMENT;
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

int evaluatePairs(const Job& job)
{
    const evaluation::Experiment& experiment = job.experiment;
    evaluation::ResultsFile results(experiment.folder, job.options, job.fresh);
    const std::vector<std::string> complaints = evaluation::run(experiment, results, showProgress);
    for (const std::string& complaint : complaints)
        std::cerr << "gcpw_evaluate: " << complaint << '\n';
    const std::string report = experiment.folder + "/report.md";
    const evaluation::RunTable rows = results.rows();
    writeText(report, evaluation::markdownPage(rows, experiment.methods, experiment.inputs));
    std::cout << report << " and results.csv written\n";
    bool whole = complaints.empty();
    if (job.sheets && experiment.degrees.front() == 0)
        whole = writeSheets(experiment, rows) && whole;
    return whole ? EXIT_STITCHED : EXIT_NO_ALIGNMENT;
}

/// @param program path of gcpw_stitch
void evaluateSets(const Job& job, const std::string& program)
{
    const std::string report = job.experiment.folder + "/sets.md";
    const auto say = [](const std::string& set, const std::string& method)
    { std::cerr << "stitching " << set << (method == "none" ? " with OpenCV alone\n" : " with GCPW\n"); };
    writeText(report, evaluation::stitchSets(job.sets, program, job.stitch_options, job.experiment.folder, job.fresh, say));
    std::cout << report << " and sets.csv written\n";
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
    const std::string about = "Compares the methods on pairs of photographs, as they are and with synthetic colour variation.\n"
                              "Exit code: 0 all runs done, 1 some runs had no result, 2 wrong use.";
    return runProgram("gcpw_evaluate", argc, argv, KEYS, about, [&](const cv::CommandLineParser& parser)
    {
        const Job job = parse(parser);
        if (!job.write_inputs.empty())
            return writeInputs(job.experiment, job.write_inputs);
        cv::setNumThreads(1); // a worker is a thread: no matter how many there are, each run is the same
        const int code = job.experiment.pairs.empty() ? static_cast<int>(EXIT_STITCHED) : evaluatePairs(job);
        if (!job.sets.empty())
            evaluateSets(job, siblingOf(argv[0], "gcpw_stitch"));
        return code;
    });
}
