// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#include "evaluation/results.hpp"

#include <cstdlib>
#include <opencv2/core.hpp>

namespace evaluation
{

namespace
{

const Cells FIRST_COLUMNS = {"pair", "method", "degree", "input", "status", "ncc", "zncc", "folds", "align_ms", "match_ms"};
const size_t KEY_COLUMNS = 4;

/// Later measures stand behind the first ones, so that whoever reads these by their place goes on.
Cells allColumns()
{
    Cells columns = FIRST_COLUMNS;
    for (const AppearanceColumn& column : appearanceColumns())
        columns.emplace_back(column.name);
    return columns;
}

Cells keyCells(const RunKey& key)
{
    // Two digits, so that the order of text is that of numbers.
    return {key.pair, key.method, cv::format("%02d", key.degree), std::to_string(key.input)};
}

double numberOf(const Cells& row, size_t column)
{
    char* end = nullptr;
    const double value = std::strtod(row[column].c_str(), &end);
    if (row[column].empty() || *end != '\0')
        CV_Error(cv::Error::StsParseError, "results.csv: '" + row[column] + "' is no " + FIRST_COLUMNS[column] + "; remove its row, or --fresh");
    return value;
}

} // namespace

ResultsFile::ResultsFile(const std::string& folder, const Cells& options, bool fresh)
    : file_(folder, "results", allColumns(), KEY_COLUMNS, options, fresh)
{
    rows(); // complains before any work
}

bool ResultsFile::has(const RunKey& key) const
{
    return file_.has(keyCells(key));
}

void ResultsFile::append(const RunKey& key, const RunResult& r)
{
    Cells row = keyCells(key);
    for (const std::string& cell : {r.status, cv::format("%.6f", r.ncc), cv::format("%.6f", r.zncc), std::to_string(r.folds),
                                    cv::format("%.1f", r.align_ms), cv::format("%.1f", r.match_ms)})
        row.push_back(cell);
    appendCells(r, row);
    file_.append(row);
}

RunTable ResultsFile::rows() const
{
    RunTable table;
    for (const auto& item : file_.rows())
    {
        const Cells& row = item.second;
        RunResult result;
        static_cast<Appearance&>(result) = readAppearance(row, FIRST_COLUMNS.size());
        result.status = row[4];
        result.ncc = numberOf(row, 5);
        result.zncc = numberOf(row, 6);
        result.folds = static_cast<int>(numberOf(row, 7));
        result.align_ms = numberOf(row, 8);
        result.match_ms = numberOf(row, 9);
        table[{row[0], row[1], static_cast<int>(numberOf(row, 2)), static_cast<int>(numberOf(row, 3))}] = result;
    }
    return table;
}

} // namespace evaluation
