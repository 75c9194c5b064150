// Part of the GCPW module for OpenCV. Licence: Apache-2.0 (see LICENSE).
#include "evaluation/tables.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <opencv2/core.hpp>
#include <set>

namespace evaluation
{

namespace
{

typedef double RunResult::*Measure;

const double NEAR_FIRST = 1.02; ///< a method within 2 % of the best of a pair shares its place

/// The rows, asked for by method and degree.
class Runs
{
public:
    Runs(const RunTable& rows, const std::vector<const PairMethod*>& methods) : rows_(rows), methods_(methods)
    {
        for (const auto& row : rows)
        {
            pairs_.insert(row.first.pair);
            degrees_.insert(row.first.degree);
        }
    }

    const std::vector<const PairMethod*>& methods() const { return methods_; }
    const std::set<std::string>& pairs() const { return pairs_; }
    const std::set<int>& degrees() const { return degrees_; }

    /// Null if missing. A method that does not look at pixels is the same at every degree.
    const RunResult* find(const std::string& pair, const PairMethod& method, int degree) const
    {
        const auto found = rows_.find({pair, method.name, method.looks_at_pixels ? degree : 0});
        return found == rows_.end() ? nullptr : &found->second;
    }

    double value(const std::string& pair, const PairMethod& method, int degree, Measure measure) const
    {
        const RunResult* result = find(pair, method, degree);
        return result ? result->*measure : std::numeric_limits<double>::quiet_NaN();
    }

    /// Pairs that every method has a score of at this degree.
    std::vector<std::string> completePairs(int degree) const
    {
        std::vector<std::string> complete;
        for (const std::string& pair : pairs_)
            if (std::all_of(methods_.begin(), methods_.end(), [&](const PairMethod* method)
                            { return std::isfinite(value(pair, *method, degree, &RunResult::zncc)); }))
                complete.push_back(pair);
        return complete;
    }

    double mean(const std::vector<std::string>& pairs, const PairMethod& method, int degree, Measure measure, bool geometric) const
    {
        double sum = 0;
        for (const std::string& pair : pairs)
        {
            const double v = value(pair, method, degree, measure);
            sum += geometric ? std::log(std::max(v, 1e-9)) : v;
        }
        sum /= static_cast<double>(pairs.size());
        return geometric ? std::exp(sum) : sum;
    }

private:
    const RunTable& rows_;
    const std::vector<const PairMethod*>& methods_;
    std::set<std::string> pairs_;
    std::set<int> degrees_;
};

std::string headOf(const std::string& first, const std::vector<std::string>& columns)
{
    std::string head = "| " + first + " |";
    std::string rule = "|---|";
    for (const std::string& column : columns)
    {
        head += " " + column + " |";
        rule += "---:|";
    }
    return head + "\n" + rule + "\n";
}

std::string headOf(const std::string& first, const std::vector<const PairMethod*>& methods)
{
    std::vector<std::string> columns;
    for (const PairMethod* method : methods)
        columns.emplace_back(method->label);
    return headOf(first, columns);
}

/// One row; the least value in bold, a dash for none.
std::string rowOf(const std::string& name, const std::vector<double>& values, const char* form)
{
    double best = std::numeric_limits<double>::infinity();
    for (double value : values)
        best = std::isfinite(value) ? std::min(best, value) : best;
    std::string row = "| " + name + " |";
    for (double value : values)
    {
        const std::string text = std::isfinite(value) ? cv::format(form, value) : "-";
        row += value == best ? " **" + text + "** |" : " " + text + " |";
    }
    return row + "\n";
}

std::string pairTable(const Runs& runs, Measure measure, const char* form)
{
    std::string table = headOf("pair", runs.methods());
    const auto valuesOf = [&](auto value)
    {
        std::vector<double> values;
        for (const PairMethod* method : runs.methods())
            values.push_back(value(*method));
        return values;
    };
    for (const std::string& pair : runs.pairs())
        table += rowOf(pair, valuesOf([&](const PairMethod& method) { return runs.value(pair, method, 0, measure); }), form);
    const std::vector<std::string> complete = runs.completePairs(0);
    if (complete.empty())
        return table + "\n";
    const std::string count = cv::format(" of %zu", complete.size());
    table += rowOf("mean" + count,
                   valuesOf([&](const PairMethod& method) { return runs.mean(complete, method, 0, measure, false); }), form);
    table += rowOf("geometric mean" + count,
                   valuesOf([&](const PairMethod& method) { return runs.mean(complete, method, 0, measure, true); }), form);
    return table + "\n";
}

/// On how many pairs GCPW leads, and who leads on the others.
std::string placeOfGcpw(const Runs& runs)
{
    const PairMethod* gcpw = nullptr;
    for (const PairMethod* method : runs.methods())
        gcpw = method->name == std::string("gcpw") ? method : gcpw;
    if (!gcpw)
        return std::string();
    int first = 0;
    int near = 0;
    std::string others;
    const std::vector<std::string> complete = runs.completePairs(0);
    for (const std::string& pair : complete)
    {
        const PairMethod* best = gcpw;
        for (const PairMethod* method : runs.methods())
            if (runs.value(pair, *method, 0, &RunResult::zncc) < runs.value(pair, *best, 0, &RunResult::zncc))
                best = method;
        const double ratio = runs.value(pair, *gcpw, 0, &RunResult::zncc) / runs.value(pair, *best, 0, &RunResult::zncc);
        first += best == gcpw ? 1 : 0;
        near += ratio <= NEAR_FIRST ? 1 : 0;
        if (best != gcpw)
            others += cv::format("- %s: %s leads, GCPW is %.1f %% behind\n", pair.c_str(), best->label, 100 * (ratio - 1));
    }
    return cv::format("GCPW is first on %d of %zu pairs, and first or within 2 %% of it on %d.\n\n", first, complete.size(), near) +
           others + (others.empty() ? "" : "\n");
}

/// Folds over all runs, and the median time of a run.
std::string costTable(const Runs& runs)
{
    std::string table = headOf("method", std::vector<std::string>{"runs", "folded quads", "runs with folds", "median ms", "largest ms"});
    for (const PairMethod* method : runs.methods())
    {
        int folds = 0;
        int folded_runs = 0;
        std::vector<double> times;
        for (const std::string& pair : runs.pairs())
            for (int degree : runs.degrees())
                if (const RunResult* result = degree == 0 || method->looks_at_pixels ? runs.find(pair, *method, degree) : nullptr)
                {
                    folds += result->folds;
                    folded_runs += result->folds > 0 ? 1 : 0;
                    times.push_back(result->align_ms);
                }
        std::sort(times.begin(), times.end());
        table += cv::format("| %s | %zu | %d | %d | %.0f | %.0f |\n", method->label, times.size(), folds, folded_runs,
                            times.empty() ? 0.0 : times[times.size() / 2], times.empty() ? 0.0 : times.back());
    }
    return table + "\n";
}

std::string degreeTable(const Runs& runs)
{
    std::string table = headOf("degree", runs.methods());
    for (int degree : runs.degrees())
    {
        const std::vector<std::string> complete = runs.completePairs(degree);
        std::vector<double> means;
        for (const PairMethod* method : runs.methods())
            means.push_back(complete.empty() ? std::numeric_limits<double>::quiet_NaN()
                                             : runs.mean(complete, *method, degree, &RunResult::zncc, false));
        table += rowOf(std::to_string(degree), means, "%.2f");
    }
    return table + "\n";
}

} // namespace

std::string markdownPage(const RunTable& rows, const std::vector<const PairMethod*>& methods)
{
    const Runs runs(rows, methods);
    std::string page = "# Evaluation of pairs\n\nLower is better; the least of a row is bold.\n\n";
    page += "## Photographs as they are: zncc\n\n" + pairTable(runs, &RunResult::zncc, "%.1f") + placeOfGcpw(runs);
    page += "## Photographs as they are: ncc\n\n" + pairTable(runs, &RunResult::ncc, "%.2f");
    if (runs.degrees().size() > 1)
        page += "## Synthetic colour variation: mean zncc by degree\n\n" + degreeTable(runs);
    page += "## Folds and time, all degrees\n\nProcessor time of everything after the matching, one thread a run.\n\n" + costTable(runs);
    return page;
}

} // namespace evaluation
