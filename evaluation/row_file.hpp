// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#ifndef GCPW_EVALUATION_ROW_FILE_HPP
#define GCPW_EVALUATION_ROW_FILE_HPP

#include <fstream>
#include <map>
#include <mutex>
#include <string>
#include <vector>

namespace evaluation
{

typedef std::vector<std::string> Cells;

/** @brief A CSV table that survives an interruption: each row is in the file before the next is begun.

Beside NAME.csv lies NAME_options.txt, what the rows depend on: going on with other options is refused. */
class RowFile
{
public:
    /** @brief Opens or begins folder/name.csv.
    @param columns their names  @param key_columns how many of the first say which row it is
    @param options lines "option=value" of all that changes a row
    @param fresh forgets what is there
    @throws cv::Exception that names the option if the rows are of others, the line if the file is no such table, or the
    path if it cannot be written */
    RowFile(const std::string& folder, const std::string& name, const Cells& columns, size_t key_columns, const Cells& options,
            bool fresh);

    bool has(const Cells& key) const;

    /// Adds a row, or replaces the one of its key, and flushes it. Threads may call it together.
    /// @param row a cell for each column, without commas and line ends
    void append(const Cells& row);

    /// Writes all rows anew in the order of their keys, so that the file does not tell who finished first.
    void sort();

    /// By key. Call it when no other thread appends.
    const std::map<Cells, Cells>& rows() const { return rows_; }

private:
    void read();
    void writeAll();

    std::string path_;
    Cells columns_;
    size_t key_columns_;
    std::ofstream file_;
    mutable std::mutex mutex_;
    std::map<Cells, Cells> rows_;
};

} // namespace evaluation

#endif
