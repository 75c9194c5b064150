// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#include "evaluation/row_file.hpp"

#include <filesystem>
#include <opencv2/core.hpp>
#include <sstream>
#include "evaluation/pair_folder.hpp"

namespace fs = std::filesystem;

namespace evaluation
{

namespace
{

std::string joined(const Cells& cells)
{
    std::string line;
    for (size_t i = 0; i < cells.size(); ++i)
        line += (i ? "," : "") + cells[i];
    return line;
}

Cells split(const std::string& line)
{
    Cells cells(1);
    for (const char c : line)
        if (c == ',')
            cells.emplace_back();
        else
            cells.back() += c;
    return cells;
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
std::string difference(const Cells& before, const Cells& now)
{
    const auto valueOf = [](const Cells& options, const std::string& name)
    {
        for (const std::string& option : options)
            if (option.compare(0, name.size() + 1, name + "=") == 0)
                return option.substr(name.size() + 1);
        return std::string("not there");
    };
    for (const Cells* options : {&now, &before})
        for (const std::string& option : *options)
        {
            const std::string name = option.substr(0, option.find('='));
            if (valueOf(before, name) != valueOf(now, name))
                return name + " was " + valueOf(before, name) + ", is " + valueOf(now, name);
        }
    return std::string();
}

/// Writes lines under another name first, so that no half-written file is ever left.
void writeLines(const std::string& path, const std::vector<std::string>& lines)
{
    const std::string partial = path + ".partial";
    std::ofstream file(partial);
    for (const std::string& line : lines)
        file << line << '\n';
    file.close();
    std::error_code error;
    if (file)
        fs::rename(partial, path, error);
    if (!file || error)
        CV_Error(cv::Error::StsError, "cannot write " + path);
}

} // namespace

RowFile::RowFile(const std::string& folder, const std::string& name, const Cells& columns, size_t key_columns,
                 const Cells& options, bool fresh)
    : path_(folder + "/" + name + ".csv"), columns_(columns), key_columns_(key_columns)
{
    makeFolder(folder);
    const std::string options_path = folder + "/" + name + "_options.txt";
    if (!fresh && fs::exists(path_))
    {
        const std::string changed = difference(readLines(options_path), options);
        if (!changed.empty())
            CV_Error(cv::Error::StsBadArg, path_ + " holds results of other options: " + changed +
                                               "; choose another --out, or --fresh to forget them");
        read();
    }
    writeLines(options_path, options);
    writeAll();
}

void RowFile::read()
{
    std::vector<std::string> lines = readLines(path_);
    if (lines.size() > 1 && !endsLine(path_))
        lines.pop_back(); // an interruption has cut it
    for (size_t i = 0; i < lines.size(); ++i)
    {
        const Cells cells = split(lines[i]);
        if (i == 0 ? cells != columns_ : cells.size() != columns_.size())
            CV_Error(cv::Error::StsParseError,
                     cv::format("%s, line %zu is no row of this table; remove it, or --fresh", path_.c_str(), i + 1));
        if (i > 0)
            rows_[Cells(cells.begin(), cells.begin() + static_cast<long>(key_columns_))] = cells;
    }
}

bool RowFile::has(const Cells& key) const
{
    const std::lock_guard<std::mutex> lock(mutex_);
    return rows_.count(key) > 0;
}

void RowFile::append(const Cells& row)
{
    CV_CheckEQ(row.size(), columns_.size(), "a row has a cell for each column");
    const std::lock_guard<std::mutex> lock(mutex_);
    file_ << joined(row) << std::endl;
    if (!file_)
        CV_Error(cv::Error::StsError, "cannot write " + path_);
    rows_[Cells(row.begin(), row.begin() + static_cast<long>(key_columns_))] = row;
}

void RowFile::sort()
{
    const std::lock_guard<std::mutex> lock(mutex_);
    writeAll();
}

void RowFile::writeAll()
{
    file_.close();
    std::vector<std::string> lines(1, joined(columns_));
    for (const auto& row : rows_)
        lines.push_back(joined(row.second));
    writeLines(path_, lines);
    file_.open(path_, std::ios::app);
}

} // namespace evaluation
