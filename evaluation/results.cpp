// Part of the GCPW module for OpenCV. Licence: Apache-2.0 (see LICENSE).
#include "evaluation/results.hpp"

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <opencv2/core.hpp>
#include <sstream>
#include "evaluation/pair_folder.hpp"

namespace fs = std::filesystem;

namespace evaluation
{

namespace
{

const char* const HEADER = "pair,method,degree,status,ncc,zncc,folds,align_ms,match_ms";

std::string lineOf(const RunKey& key, const RunResult& r)
{
    return key.pair + "," + key.method +
           cv::format(",%d,%s,%.6f,%.6f,%d,%.1f,%.1f", key.degree, r.status.c_str(), r.ncc, r.zncc, r.folds, r.align_ms,
                      r.match_ms);
}

bool parseLine(const std::string& line, RunKey& key, RunResult& r)
{
    std::istringstream fields(line);
    std::string numbers;
    int end = 0;
    const bool named = std::getline(fields, key.pair, ',') && std::getline(fields, key.method, ',');
    std::string degree;
    if (!named || !std::getline(fields, degree, ',') || !std::getline(fields, r.status, ',') || !std::getline(fields, numbers))
        return false;
    int end_degree = 0;
    return std::sscanf(degree.c_str(), "%d%n", &key.degree, &end_degree) == 1 && end_degree == static_cast<int>(degree.size()) &&
           std::sscanf(numbers.c_str(), "%lf,%lf,%d,%lf,%lf%n", &r.ncc, &r.zncc, &r.folds, &r.align_ms, &r.match_ms, &end) == 5 &&
           end == static_cast<int>(numbers.size());
}

std::vector<std::string> readLines(const std::string& path)
{
    std::vector<std::string> lines;
    std::ifstream file(path);
    for (std::string line; std::getline(file, line);)
        lines.push_back(line);
    return lines;
}

/// Whether the last line of a file is whole.
bool endsLine(const std::string& path)
{
    std::ifstream file(path, std::ios::binary | std::ios::ate);
    file.seekg(-1, std::ios::end);
    return file.get() == '\n';
}

/// The first option that changed, as "name was .., is ..".
std::string difference(const std::vector<std::string>& before, const std::vector<std::string>& now)
{
    const auto valueOf = [](const std::vector<std::string>& options, const std::string& name)
    {
        for (const std::string& option : options)
            if (option.compare(0, name.size() + 1, name + "=") == 0)
                return option.substr(name.size() + 1);
        return std::string("not there");
    };
    for (const std::vector<std::string>* options : {&now, &before})
        for (const std::string& option : *options)
        {
            const std::string name = option.substr(0, option.find('='));
            if (valueOf(before, name) != valueOf(now, name))
                return name + " was " + valueOf(before, name) + ", is " + valueOf(now, name);
        }
    return std::string();
}

} // namespace

ResultsFile::ResultsFile(const std::string& folder, const std::vector<std::string>& options, bool fresh)
    : path_(folder + "/results.csv")
{
    makeFolder(folder);
    const std::string options_path = folder + "/options.txt";
    if (!fresh && fs::exists(path_))
    {
        const std::string changed = difference(readLines(options_path), options);
        if (!changed.empty())
            CV_Error(cv::Error::StsBadArg, folder + " holds results of other options: " + changed +
                                               "; choose another --out, or --fresh to forget them");
        std::vector<std::string> lines = readLines(path_);
        if (lines.size() > 1 && !endsLine(path_))
            lines.pop_back(); // an interruption has cut it
        for (size_t i = 0; i < lines.size(); ++i)
        {
            RunKey key;
            RunResult result;
            if (i == 0 ? lines[i] == HEADER : parseLine(lines[i], key, result))
            {
                if (i > 0)
                    rows_[key] = result;
            }
            else
                CV_Error(cv::Error::StsParseError,
                         cv::format("%s, line %zu is no row of this table; remove it, or --fresh", path_.c_str(), i + 1));
        }
    }
    std::ofstream options_file(options_path);
    for (const std::string& option : options)
        options_file << option << '\n';
    options_file.close();
    if (!options_file)
        CV_Error(cv::Error::StsError, "cannot write " + options_path);
    writeAll();
}

bool ResultsFile::has(const RunKey& key) const
{
    const std::lock_guard<std::mutex> lock(mutex_);
    return rows_.count(key) > 0;
}

void ResultsFile::append(const RunKey& key, const RunResult& result)
{
    const std::lock_guard<std::mutex> lock(mutex_);
    const std::string line = lineOf(key, result);
    file_ << line << std::endl;
    if (!file_)
        CV_Error(cv::Error::StsError, "cannot write " + path_);
    // As it would be read again: a table that was interrupted and one that was not are the same.
    RunKey same_key;
    RunResult rounded;
    parseLine(line, same_key, rounded);
    rows_[key] = rounded;
}

void ResultsFile::sort()
{
    const std::lock_guard<std::mutex> lock(mutex_);
    writeAll();
}

void ResultsFile::writeAll()
{
    file_.close();
    const std::string partial = path_ + ".partial";
    std::ofstream whole(partial);
    whole << HEADER << '\n';
    for (const auto& row : rows_)
        whole << lineOf(row.first, row.second) << '\n';
    whole.close();
    std::error_code error;
    if (whole)
        fs::rename(partial, path_, error);
    if (!whole || error)
        CV_Error(cv::Error::StsError, "cannot write " + path_);
    file_.open(path_, std::ios::app);
}

} // namespace evaluation
