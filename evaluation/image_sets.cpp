// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#include "evaluation/image_sets.hpp"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <limits>
#include <tuple>
#include <opencv2/gcpw/pair.hpp>
#include <opencv2/imgcodecs.hpp>
#include "evaluation/appearance.hpp"
#include "evaluation/child_process.hpp"
#include "evaluation/pair_folder.hpp"
#include "evaluation/warped_image.hpp"

namespace fs = std::filesystem;

namespace evaluation
{

namespace
{

const int MIN_OVERLAP = 2000; ///< px; less says little
const Cells FIRST_COLUMNS = {"set", "method", "exit_code", "images", "kept", "pairs", "ncc", "zncc", "color_difference", "seconds",
                             "cpu_seconds", "peak_mb"};
const size_t KEY_COLUMNS = 2;

/// Later measures stand behind the first ones, as in results.csv.
Cells allColumns()
{
    Cells columns = FIRST_COLUMNS;
    for (const AppearanceColumn& column : appearanceColumns())
        columns.emplace_back(column.name);
    return columns;
}

std::string numberOrDash(const std::string& cell, const char* form)
{
    const double value = cell.empty() ? std::numeric_limits<double>::quiet_NaN() : std::atof(cell.c_str());
    return std::isfinite(value) ? cv::format(form, value) : std::string("-");
}

std::string scoresTable(const std::vector<Cells>& rows)
{
    std::string table = "| set | method | images kept | zncc | ncc | colour difference | seconds | CPU seconds | peak MiB |\n"
                        "|---|---|---:|---:|---:|---:|---:|---:|---:|\n";
    for (const Cells& row : rows)
    {
        table += "| " + row[0] + " | " + row[1] + " | " + row[4] + " of " + row[3] + " | " + numberOrDash(row[7], "%.1f") + " | " +
                 numberOrDash(row[6], "%.2f") + " | " + numberOrDash(row[8], "%.1f") + " | " + numberOrDash(row[9], "%.1f") + " | " +
                 numberOrDash(row[10], "%.1f") + " | " + numberOrDash(row[11], "%.0f") + " |\n";
    }
    return table;
}

std::string appearanceTable(const std::vector<Cells>& rows)
{
    std::string table = "| set | method |";
    std::string rule = "|---|---|";
    for (const AppearanceColumn& column : appearanceColumns())
    {
        table += " " + std::string(column.heading) + " |";
        rule += "---:|";
    }
    table += "\n" + rule + "\n";
    for (const Cells& row : rows)
    {
        table += "| " + row[0] + " | " + row[1] + " |";
        size_t cell = FIRST_COLUMNS.size();
        for (const AppearanceColumn& column : appearanceColumns())
            table += " " + numberOrDash(row[cell++], column.form) + " |";
        table += "\n";
    }
    return table;
}

std::string markdownPage(const std::map<Cells, Cells>& rows)
{
    std::vector<Cells> ordered;
    for (const auto& item : rows)
        ordered.push_back(item.second);
    std::sort(ordered.begin(), ordered.end(),
              [](const Cells& a, const Cells& b) // OpenCV alone comes first
              { return std::make_tuple(a[0], a[1] != "none", a[1]) < std::make_tuple(b[0], b[1] != "none", b[1]); });
    return "# Evaluation of sets\n\n`none` is cv::Stitcher alone. Lower is better for all but the images kept.\n\n## Scores\n\n" +
           scoresTable(ordered) +
           "\n## Appearance\n\nSee doc/evaluation.md. Bend and shape are measured against the base warper, so that OpenCV alone has 0.\n\n" +
           appearanceTable(ordered);
}

/// What a person sees of a panorama. OpenCV alone bends nothing: its warp is what bends are measured against.
Appearance appearanceOf(const ImageSet& set, const std::string& place, const std::string& model)
{
    Appearance appearance;
    addPictures(readDump(place), appearance);
    if (model.empty())
    {
        appearance.bend_p95 = appearance.bend_share = appearance.shape = 0;
        return appearance;
    }
    const cv::gcpw::Rig rig = cv::gcpw::Rig::load(model);
    const auto photograph = [&](int index) { return cv::imread(set.images.at(static_cast<size_t>(index))); };
    std::vector<SegmentBend> all;
    bool known_warper = true;
    try
    {
        for (const std::vector<SegmentBend>& bends : bendsOf(rig, photograph))
            all.insert(all.end(), bends.begin(), bends.end());
    }
    catch (const cv::Exception& error)
    {
        if (error.code != cv::Error::StsBadArg)
            throw;
        known_warper = false; // segments cannot be followed: no bend rather than a wrong one, and the other sets go on
    }
    addMeshes(rig.alignment, all, appearance);
    if (!known_warper)
        appearance.bend_p95 = appearance.bend_share = std::numeric_limits<double>::quiet_NaN();
    return appearance;
}

Cells rowOf(const ImageSet& set, const std::string& method, const SetScore& score, const ChildResult& timed,
            const Appearance& appearance)
{
    Cells row = {set.name,
                 method,
                 std::to_string(timed.exit_code),
                 std::to_string(set.images.size()),
                 std::to_string(score.images),
                 std::to_string(score.pairs),
                 cv::format("%.6f", score.ncc),
                 cv::format("%.6f", score.zncc),
                 cv::format("%.6f", score.color_difference),
                 cv::format("%.2f", timed.seconds),
                 cv::format("%.2f", timed.cpu_seconds),
                 cv::format("%.1f", timed.peak_mb)};
    appendCells(appearance, row);
    return row;
}

/// The row of one set by one method.
Cells stitchOne(const ImageSet& set, const std::string& method, const std::string& program,
                const std::vector<std::string>& arguments, const std::string& folder)
{
    const std::string place = folder + "/sets/" + set.name + "/" + method;
    fs::remove_all(place);
    makeFolder(place);
    std::vector<std::string> command = set.images;
    command.insert(command.end(), arguments.begin(), arguments.end());
    command.push_back("--method=" + method);
    command.push_back("--output=" + place + "/panorama.jpg");
    // The second call writes the picture once more; what is scored is the whole of the largest panorama.
    command.insert(command.end(), {"--force", "--crop=none", "--panoramas=largest"});
    const ChildResult timed = runChild(program, command); // without the dump, which costs time and memory of its own
    SetScore score;
    score.ncc = score.zncc = score.color_difference = std::numeric_limits<double>::quiet_NaN();
    if (timed.exit_code > 1)
        CV_Error(cv::Error::StsError, cv::format("%s ended with %d on the set %s", program.c_str(), timed.exit_code, set.name.c_str()));
    Appearance appearance;
    if (timed.exit_code == 0)
    {
        const std::string model = method == "none" ? std::string() : place + "/model.yml.gz";
        command.push_back("--dump=" + place);
        if (!model.empty())
            command.push_back("--save_model=" + model);
        runChild(program, command);
        score = scoreDump(place);
        appearance = appearanceOf(set, place, model);
    }
    return rowOf(set, method, score, timed, appearance);
}

/// The row of what another program made of a set.
Cells readOne(const ImageSet& set, const PairMethod& method)
{
    const std::string place = method.results + "/" + set.name;
    const double unknown = std::numeric_limits<double>::quiet_NaN();
    ChildResult untimed;
    untimed.seconds = untimed.cpu_seconds = untimed.peak_mb = unknown;
    SetScore score;
    score.ncc = score.zncc = score.color_difference = unknown;
    Appearance appearance;
    if (fs::exists(place + "/corners.csv"))
    {
        score = scoreDump(place);
        addPictures(readDump(place), appearance);
    }
    else if (!fs::exists(place + "/panorama.png") && !fs::exists(place + "/panorama.jpg"))
        CV_Error(cv::Error::StsObjectNotFound,
                 "there is no corners.csv and no panorama.png or panorama.jpg in " + place);
    Cells row = rowOf(set, method.name, score, untimed, appearance);
    if (score.images == 0)
        row[4] = "?"; // how many photographs a picture shows is not known
    return row;
}

} // namespace

std::vector<ImageSet> findSets(const std::string& folder)
{
    std::vector<ImageSet> sets;
    for (const fs::path& path : subfolders(folder))
    {
        ImageSet set;
        set.name = path.filename().string();
        for (const fs::directory_entry& file : fs::directory_iterator(path))
            if (file.is_regular_file() && cv::haveImageReader(file.path().string()))
                set.images.push_back(file.path().string());
        std::sort(set.images.begin(), set.images.end());
        if (set.images.size() >= 2)
            sets.push_back(set);
    }
    if (sets.empty())
        CV_Error(cv::Error::StsObjectNotFound, folder + " holds no sets; it needs a folder a set, each with two images or more");
    return sets;
}

SetScore scoreDump(const std::string& folder)
{
    const std::vector<WarpedImage> dump = readDump(folder);
    SetScore score;
    score.images = static_cast<int>(dump.size());
    double weight = 0;
    for (size_t i = 0; i < dump.size(); ++i)
        for (size_t j = i + 1; j < dump.size(); ++j)
        {
            const cv::Rect common = dump[i].place & dump[j].place;
            if (common.empty())
                continue;
            const cv::Rect a = common - dump[i].place.tl();
            const cv::Rect b = common - dump[j].place.tl();
            cv::gcpw::PairCanvas canvas;
            canvas.source = dump[i].image(a);
            canvas.source_mask = dump[i].mask(a);
            canvas.target = dump[j].image(b);
            canvas.target_mask = dump[j].mask(b);
            const cv::Mat overlap = canvas.source_mask & canvas.target_mask;
            const int area = cv::countNonZero(overlap);
            const cv::gcpw::Score pair = area < MIN_OVERLAP ? cv::gcpw::Score() : cv::gcpw::scorePair(canvas);
            if (area < MIN_OVERLAP || !std::isfinite(pair.ncc) || !std::isfinite(pair.zncc))
                continue;
            cv::Mat difference;
            cv::absdiff(dump[i].corrected(a), dump[j].corrected(b), difference);
            const cv::Scalar mean = cv::mean(difference, overlap);
            score.ncc += area * pair.ncc;
            score.zncc += area * pair.zncc;
            score.color_difference += area * (mean[0] + mean[1] + mean[2]) / 3;
            weight += area;
            ++score.pairs;
        }
    for (double* sum : {&score.ncc, &score.zncc, &score.color_difference})
        *sum = weight > 0 ? *sum / weight : std::numeric_limits<double>::quiet_NaN();
    return score;
}

std::string stitchSets(const std::vector<ImageSet>& sets, const std::vector<PairMethod>& externals,
                       const std::string& program, const std::vector<std::string>& arguments, const std::string& folder,
                       bool fresh,
                       const std::function<void(const std::string& set, const std::string& method)>& progress,
                       std::vector<std::string>& complaints)
{
    Cells options;
    for (const std::string& argument : arguments)
        options.push_back(argument.substr(argument.find_first_not_of('-')));
    RowFile file(folder, "sets", allColumns(), KEY_COLUMNS, options, fresh);
    const auto attempt = [&](const ImageSet& set, const std::string& method, const std::function<Cells()>& make)
    {
        try
        {
            file.append(make());
        }
        catch (const cv::Exception& error)
        {
            complaints.push_back(set.name + ", " + method + ": " + error.err);
        }
    };
    for (const ImageSet& set : sets)
    {
        for (const std::string method : {"none", "gcpw"})
        {
            if (file.has({set.name, method}))
                continue;
            if (progress)
                progress(set.name, method);
            attempt(set, method, [&] { return stitchOne(set, method, program, arguments, folder); });
        }
        for (const PairMethod& method : externals)
            attempt(set, method.name, [&] { return readOne(set, method); });
    }
    file.sort();
    return markdownPage(file.rows());
}

} // namespace evaluation
