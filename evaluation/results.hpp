// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#ifndef GCPW_EVALUATION_RESULTS_HPP
#define GCPW_EVALUATION_RESULTS_HPP

#include <map>
#include <string>
#include <tuple>
#include "evaluation/appearance.hpp"
#include "evaluation/row_file.hpp"

namespace evaluation
{

/// What one run is: which method on which input of which pair at which degree of colour variation.
struct RunKey
{
    std::string pair;
    std::string method;
    int degree = 0;
    int input = 1; ///< see jitteredInput()

    bool operator<(const RunKey& other) const
    {
        return std::tie(pair, method, degree, input) < std::tie(other.pair, other.method, other.degree, other.input);
    }
};

/// What one run gave; its appearance is measured at degree 0 only, the photographs as they are.
struct RunResult : Appearance
{
    std::string status =
        "ok"; ///< "ok", "rough", "no_alignment", "failed", or "picture" of one that cannot be measured; scores are NaN for the last three
    double ncc = 0;
    double zncc = 0;
    int folds = 0;
    double align_ms = 0; ///< processor time of all work after the matching, measured around the method: Timings are wall time
    double match_ms = 0; ///< the same of features and matching, shared by all runs of the input
};

typedef std::map<RunKey, RunResult> RunTable;

/// The runs of an experiment, in FOLDER/results.csv; see RowFile.
class ResultsFile
{
public:
    /// @throws cv::Exception as RowFile does, also if a cell of results.csv is not what its column says
    ResultsFile(const std::string& folder, const Cells& options, bool fresh);

    bool has(const RunKey& key) const;

    /// Adds a run and flushes it. Threads may call it together.
    void append(const RunKey& key, const RunResult& result);

    /// Puts the file in the order of its keys.
    void sort() { file_.sort(); }

    /// As they stand in the file, so that it does not matter whether the work was interrupted. Call it when no other
    /// thread appends.
    RunTable rows() const;

private:
    RowFile file_;
};

} // namespace evaluation

#endif
