// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#include "evaluation/tables.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <opencv2/core.hpp>
#include <set>
#include "evaluation/input_jitter.hpp"
#include "evaluation/spread.hpp"

namespace evaluation
{

namespace
{

typedef double RunResult::*Measure;

/// A number in a table, and what decides whether it differs from another.
struct Cell
{
    double value = std::numeric_limits<double>::quiet_NaN();
    Scores scores; ///< of the same thing, on each input
};

typedef std::vector<Cell> Row;

/// The rows, asked for by method, degree and input.
class Runs
{
public:
    Runs(const RunTable& rows, const std::vector<const PairMethod*>& methods, int inputs)
        : rows_(rows), methods_(methods), inputs_(inputs)
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
    int inputs() const { return inputs_; }

    /// Null if missing. A method that does not look at pixels is the same at every degree.
    const RunResult* find(const std::string& pair, const PairMethod& method, int degree, int input) const
    {
        const auto found = rows_.find({pair, method.name, method.looks_at_pixels ? degree : 0, input});
        return found == rows_.end() ? nullptr : &found->second;
    }

    Scores scores(const std::string& pair, const PairMethod& method, int degree, Measure measure) const
    {
        Scores scores;
        for (int input = 1; input <= inputs_; ++input)
        {
            const RunResult* result = find(pair, method, degree, input);
            scores.push_back(result ? result->*measure : std::numeric_limits<double>::quiet_NaN());
        }
        return scores;
    }

    Cell cell(const std::string& pair, const PairMethod& method, int degree, Measure measure) const
    {
        const Scores all = scores(pair, method, degree, measure);
        return {median(all), all};
    }

    /// Pairs that every method has a median of at this degree.
    std::vector<std::string> completePairs(int degree) const
    {
        std::vector<std::string> complete;
        for (const std::string& pair : pairs_)
            if (std::all_of(methods_.begin(), methods_.end(), [&](const PairMethod* method)
                            { return std::isfinite(median(scores(pair, *method, degree, &RunResult::zncc))); }))
                complete.push_back(pair);
        return complete;
    }

    /// The mean over pairs of their medians, and for each input the mean of its scores. A geometric mean takes values above 0.
    Cell mean(const std::vector<std::string>& pairs, const PairMethod& method, int degree, Measure measure, bool geometric) const
    {
        const auto in = [geometric](double value) { return geometric ? std::log(std::max(value, 1e-9)) : value; };
        const auto out = [geometric](double value) { return geometric ? std::exp(value) : value; };
        const double count = static_cast<double>(pairs.size());
        double sum = 0;
        Scores sums(static_cast<size_t>(inputs_), 0.0);
        for (const std::string& pair : pairs)
        {
            const Cell one = cell(pair, method, degree, measure);
            sum += in(one.value);
            for (size_t i = 0; i < sums.size(); ++i)
                sums[i] += in(one.scores[i]);
        }
        for (double& each : sums)
            each = out(each / count);
        return {out(sum / count), sums};
    }

private:
    const RunTable& rows_;
    const std::vector<const PairMethod*>& methods_;
    int inputs_;
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

/// One line; a dash for no value. In bold the least value, and those of which it is not ahead.
std::string lineOf(const std::string& name, const Row& row, const char* form)
{
    const Cell* best = nullptr;
    for (const Cell& cell : row)
        if (std::isfinite(cell.value) && (!best || cell.value < best->value))
            best = &cell;
    std::string line = "| " + name + " |";
    for (const Cell& cell : row)
    {
        const std::string text = std::isfinite(cell.value) ? cv::format(form, cell.value) : "-";
        const bool bold = std::isfinite(cell.value) && !isAhead(best->scores, cell.scores);
        line += bold ? " **" + text + "** |" : " " + text + " |";
    }
    return line + "\n";
}

/// A cell for each method.
template <typename MakeCell>
Row rowOf(const Runs& runs, MakeCell make)
{
    Row row;
    for (const PairMethod* method : runs.methods())
        row.push_back(make(*method));
    return row;
}

std::string pairTable(const Runs& runs, Measure measure, const char* form)
{
    std::string table = headOf("pair", runs.methods());
    for (const std::string& pair : runs.pairs())
        table += lineOf(pair, rowOf(runs, [&](const PairMethod& method) { return runs.cell(pair, method, 0, measure); }), form);
    const std::vector<std::string> complete = runs.completePairs(0);
    if (complete.empty())
        return table + "\n";
    for (const bool geometric : {false, true})
    {
        const auto meanOf = [&](const PairMethod& method) { return runs.mean(complete, method, 0, measure, geometric); };
        table += lineOf((geometric ? "geometric mean" : "mean") + cv::format(" of %zu", complete.size()), rowOf(runs, meanOf), form);
    }
    return table + "\n";
}

/// Largest over smallest zncc of the inputs; nothing for one input.
std::string spreadTable(const Runs& runs)
{
    if (runs.inputs() < 2)
        return std::string();
    std::string table = headOf("pair", runs.methods());
    for (const std::string& pair : runs.pairs())
    {
        table += "| " + pair + " |";
        for (const PairMethod* method : runs.methods())
        {
            const double ratio = spread(runs.scores(pair, *method, 0, &RunResult::zncc));
            table += std::isfinite(ratio) ? cv::format(" %.2f |", ratio) : " - |";
        }
        table += "\n";
    }
    return "## Photographs as they are: spread of zncc\n\nLargest over smallest of the inputs.\n\n" + table + "\n";
}

/// On how many pairs GCPW is ahead of all others, and who is level with it or ahead on the others.
std::string placeOfGcpw(const Runs& runs)
{
    const auto isGcpw = [](const PairMethod* method) { return method->name == "gcpw"; };
    const auto gcpw = std::find_if(runs.methods().begin(), runs.methods().end(), isGcpw);
    const std::vector<std::string> complete = runs.completePairs(0);
    if (gcpw == runs.methods().end() || complete.empty())
        return std::string();
    int ahead = 0;
    int behind = 0;
    std::string others;
    for (const std::string& pair : complete)
    {
        const Cell own = runs.cell(pair, **gcpw, 0, &RunResult::zncc);
        std::string level;
        std::string leaders;
        for (const PairMethod* method : runs.methods())
        {
            const Cell other = runs.cell(pair, *method, 0, &RunResult::zncc);
            if (isAhead(other.scores, own.scores))
                leaders += (leaders.empty() ? "" : ", ") +
                           cv::format("%s (by %.0f %%)", method->label.c_str(), 100 * (own.value / other.value - 1));
            else if (!isGcpw(method) && !isAhead(own.scores, other.scores))
                level += (level.empty() ? "" : ", ") + method->label;
        }
        ahead += leaders.empty() && level.empty() ? 1 : 0;
        behind += leaders.empty() ? 0 : 1;
        if (!leaders.empty())
            others += "- " + pair + ": behind " + leaders + "\n";
        else if (!level.empty())
            others += "- " + pair + ": level with " + level + "\n";
    }
    const int count = static_cast<int>(complete.size());
    return cv::format("GCPW is ahead of all others on %d of %d pairs, level with the best on %d, behind on %d.\n\n", ahead, count,
                      count - ahead - behind, behind) +
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
                for (int input = 1; input <= runs.inputs(); ++input)
                {
                    const bool own = degree == 0 || method->looks_at_pixels; // else it is the row of degree 0
                    if (const RunResult* result = own ? runs.find(pair, *method, degree, input) : nullptr)
                    {
                        folds += result->folds;
                        folded_runs += result->folds > 0 ? 1 : 0;
                        times.push_back(result->align_ms);
                    }
                }
        std::sort(times.begin(), times.end());
        const bool timed = method->results.empty() && !times.empty(); // what another program took is not known
        table +=
            cv::format("| %s | %zu | %d | %d | ", method->label.c_str(), times.size(), folds, folded_runs) +
            (timed ? cv::format("%.0f | %.0f |\n", times[times.size() / 2], times.back()) : std::string("- | - |\n"));
    }
    return table + "\n";
}

std::vector<std::string> appearanceHeadings()
{
    std::vector<std::string> headings;
    for (const AppearanceColumn& column : appearanceColumns())
        headings.emplace_back(column.heading);
    return headings;
}

/// Median over the inputs that have the measure: a cut that keeps to the border of the overlap says nothing, not the worst.
double appearanceOf(const Runs& runs, const std::string& pair, const PairMethod& method, Measure measure)
{
    Scores present;
    for (const double score : runs.scores(pair, method, 0, measure))
        if (std::isfinite(score))
            present.push_back(score);
    return median(present);
}

/// Pairs on which every method has the measure.
std::vector<std::string> comparedPairs(const Runs& runs, Measure measure)
{
    std::vector<std::string> pairs;
    for (const std::string& pair : runs.pairs())
        if (std::all_of(runs.methods().begin(), runs.methods().end(), [&](const PairMethod* method)
                        { return std::isfinite(appearanceOf(runs, pair, *method, measure)); }))
            pairs.push_back(pair);
    return pairs;
}

std::string valueOrDash(double value, const char* form)
{
    return " " + (std::isfinite(value) ? cv::format(form, value) : std::string("-")) + " |";
}

/// Means of every method, and of how many pairs.
std::string appearanceMeans(const Runs& runs)
{
    std::string table = headOf("mean over pairs", appearanceHeadings());
    for (const PairMethod* method : runs.methods())
    {
        table += "| " + method->label + " |";
        for (const AppearanceColumn& column : appearanceColumns())
        {
            const std::vector<std::string> pairs = comparedPairs(runs, column.value);
            double sum = 0;
            for (const std::string& pair : pairs)
                sum += appearanceOf(runs, pair, *method, column.value);
            table += valueOrDash(sum / static_cast<double>(pairs.size()), column.form);
        }
        table += "\n";
    }
    table += "| pairs that all have |";
    for (const AppearanceColumn& column : appearanceColumns())
        table += cv::format(" %zu |", comparedPairs(runs, column.value).size());
    return table + "\n";
}

/// What a person sees, of every method in the mean and of the last one on each pair; nothing if it was never measured.
std::string appearanceTables(const Runs& runs)
{
    const std::vector<AppearanceColumn>& columns = appearanceColumns();
    if (std::all_of(columns.begin(), columns.end(), [&](const AppearanceColumn& column) { return comparedPairs(runs, column.value).empty(); }))
        return std::string();
    const PairMethod& last = *runs.methods().back();
    std::string pairs = headOf(std::string("pair, ") + last.label, appearanceHeadings());
    for (const std::string& pair : runs.pairs())
    {
        pairs += "| " + pair + " |";
        for (const AppearanceColumn& column : columns)
            pairs += valueOrDash(appearanceOf(runs, pair, last, column.value), column.form);
        pairs += "\n";
    }
    return "## Photographs as they are: appearance\n\nBend and shape against the homography, seams by one graph cut for all; see\n"
           "doc/evaluation.md. Lower is better, 0 cannot be seen.\n\n" +
           appearanceMeans(runs) + "\n## Photographs as they are: appearance on each pair\n\n" + pairs + "\n";
}

/// What the numbers are, and when one counts as less than another.
std::string legend(int inputs)
{
    return cv::format("zncc is 100 times the RMS, over the 5 x 5 px windows with texture in the overlap, of one minus the zero-mean\n"
                      "normalised correlation of the two images; ncc takes all windows and leaves their means. Lower is better.\n\n"
                      "Each score of a pair is the median over %d input%s (doc/evaluation.md). A method is ahead of another where it is\n"
                      "better on every input. In bold: the least of a row, and all of which it is not ahead.\n\n",
                      inputs, inputs == 1 ? "" : "s");
}

std::string degreeTable(const Runs& runs)
{
    std::string table = headOf("degree", runs.methods());
    for (int degree : runs.degrees())
    {
        const std::vector<std::string> complete = runs.completePairs(degree);
        const auto meanOf = [&](const PairMethod& method)
        { return complete.empty() ? Cell() : runs.mean(complete, method, degree, &RunResult::zncc, false); };
        table += lineOf(std::to_string(degree), rowOf(runs, meanOf), "%.2f");
    }
    return table + "\n";
}

} // namespace

std::string markdownPage(const RunTable& rows, const std::vector<const PairMethod*>& methods, int inputs)
{
    CV_Check(inputs, inputs >= 1 && inputs <= INPUTS, "a page is of 1 to 5 inputs");
    const Runs runs(rows, methods, inputs);
    std::string page = "# Evaluation of pairs\n\n" + legend(inputs);
    page += "## Photographs as they are: zncc\n\n" + pairTable(runs, &RunResult::zncc, "%.1f") + placeOfGcpw(runs);
    page += spreadTable(runs);
    page += "## Photographs as they are: ncc\n\n" + pairTable(runs, &RunResult::ncc, "%.2f");
    page += appearanceTables(runs);
    if (runs.degrees().size() > 1)
        page += "## Synthetic colour variation: mean zncc by degree\n\n" + degreeTable(runs);
    page += "## Folds and time, all degrees\n\nProcessor time of everything after the matching, one thread a run.\n\n" + costTable(runs);
    return page;
}

} // namespace evaluation
