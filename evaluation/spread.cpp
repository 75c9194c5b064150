// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#include "evaluation/spread.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <opencv2/core.hpp>

namespace evaluation
{

namespace
{

const double NONE = std::numeric_limits<double>::quiet_NaN();

/// A missing score as the worst there can be.
double orWorst(double score)
{
    return std::isfinite(score) ? score : std::numeric_limits<double>::infinity();
}

} // namespace

double median(const Scores& scores)
{
    Scores sorted;
    for (const double score : scores)
        sorted.push_back(orWorst(score));
    std::sort(sorted.begin(), sorted.end());
    const size_t half = sorted.size() / 2;
    if (sorted.empty() || !std::isfinite(sorted[half]))
        return NONE;
    return sorted.size() % 2 == 1 ? sorted[half] : 0.5 * (sorted[half - 1] + sorted[half]);
}

double spread(const Scores& scores)
{
    const auto isUsable = [](double score) { return std::isfinite(score) && score > 0; };
    if (scores.empty() || !std::all_of(scores.begin(), scores.end(), isUsable))
        return NONE;
    const auto ends = std::minmax_element(scores.begin(), scores.end());
    return *ends.second / *ends.first;
}

bool isAhead(const Scores& a, const Scores& b)
{
    CV_CheckEQ(a.size(), b.size(), "methods are compared on the same inputs");
    for (size_t i = 0; i < a.size(); ++i)
        if (!(orWorst(a[i]) < orWorst(b[i])))
            return false;
    return !a.empty();
}

double percentile(std::vector<double> values, double percent)
{
    CV_Check(percent, percent >= 0 && percent <= 100, "a percentile lies in 0..100");
    if (values.empty())
        return 0;
    std::sort(values.begin(), values.end());
    const double place = percent / 100 * static_cast<double>(values.size() - 1);
    const size_t low = static_cast<size_t>(place);
    const size_t high = std::min(low + 1, values.size() - 1);
    return values[low] + (place - static_cast<double>(low)) * (values[high] - values[low]);
}

} // namespace evaluation
