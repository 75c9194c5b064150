// Part of the GCPW module for OpenCV. Licence: Apache-2.0 (see LICENSE).
#ifndef GCPW_EVALUATION_RESULTS_HPP
#define GCPW_EVALUATION_RESULTS_HPP

#include <fstream>
#include <map>
#include <mutex>
#include <string>
#include <tuple>
#include <vector>

namespace evaluation
{

/// What one run is: which method on which pair at which degree of colour variation.
struct RunKey
{
    std::string pair;
    std::string method;
    int degree = 0;

    bool operator<(const RunKey& other) const
    {
        return std::tie(pair, method, degree) < std::tie(other.pair, other.method, other.degree);
    }
};

/// What one run gave.
struct RunResult
{
    std::string status = "ok"; ///< "ok", "rough", "no_alignment" or "failed"; scores are NaN for the last two
    double ncc = 0;
    double zncc = 0;
    int folds = 0;
    double align_ms = 0; ///< all work after the matching
    double match_ms = 0; ///< features and matching, shared by all runs of the pair
};

typedef std::map<RunKey, RunResult> RunTable;

/** @brief A table of results that survives an interruption: each row is in the file before the next is begun.

The folder holds results.csv and, in options.txt, what the results depend on: resuming with other options is refused. */
class ResultsFile
{
public:
    /** @brief Opens or begins the table of a folder.
    @param options lines "name=value" of all that changes a result
    @param fresh forgets what is there
    @throws cv::Exception that names the option if the folder holds results of others, or if the file cannot be written
    or is no such table */
    ResultsFile(const std::string& folder, const std::vector<std::string>& options, bool fresh);

    bool has(const RunKey& key) const;

    /// Adds a row and flushes it. Threads may call it together. @throws cv::Exception if it cannot be written
    void append(const RunKey& key, const RunResult& result);

    /// Writes all rows anew in the order of their keys, so that the file does not tell who finished first.
    void sort();

    /// Call it when no other thread appends.
    const RunTable& rows() const { return rows_; }

private:
    void writeAll();

    std::string path_;
    std::ofstream file_;
    mutable std::mutex mutex_;
    RunTable rows_;
};

} // namespace evaluation

#endif
