// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#include "solver/row_group.hpp"

#include <algorithm>
#include <cmath>

namespace cv
{
namespace gcpw
{

namespace
{

const double LEAST_NORM = 1e-6; ///< of a vector after projection, against before: less is rounding

double dot(const std::vector<double>& a, const std::vector<double>& b)
{
    double sum = 0;
    for (size_t k = 0; k < a.size(); ++k)
        sum += a[k] * b[k];
    return sum;
}

void subtractPart(const std::vector<double>& direction, std::vector<double>& vector)
{
    const double share = dot(direction, vector);
    for (size_t k = 0; k < vector.size(); ++k)
        vector[k] -= share * direction[k];
}

SparseColumn weightedSum(const Lattice& lattice, const std::vector<GroupRow>& rows, const std::vector<double>& weights)
{
    SparseColumn terms;
    for (size_t first = 0; first < rows.size();)
    {
        // Rows next to each other mostly lie in one quad.
        QuadRow sum{};
        size_t k = first;
        for (; k < rows.size() && rows[k].cell == rows[first].cell; ++k)
            for (size_t i = 0; i < 8; ++i)
                sum[i] += weights[k] * rows[k].row[i];
        for (int i = 0; i < 8; ++i)
            terms.push_back({2 * lattice.vertexOf(rows[first].cell, i >> 1) + (i & 1), sum[static_cast<size_t>(i)]});
        first = k;
    }
    std::stable_sort(terms.begin(), terms.end(),
                     [](const SparseEntry& a, const SparseEntry& b) { return a.index < b.index; });
    SparseColumn column;
    for (const SparseEntry& term : terms)
        if (!column.empty() && column.back().index == term.index)
            column.back().value += term.value;
        else
            column.push_back(term);
    return column;
}

} // namespace

RowGroup::RowGroup(const Lattice& lattice, const std::vector<GroupRow>& rows) : rows_(rows)
{
    for (size_t unknown = 0; unknown < 2; ++unknown)
    {
        std::vector<double> q;
        for (const GroupRow& row : rows)
            q.push_back(row.shared[unknown]);
        const double before = std::sqrt(dot(q, q));
        for (const std::vector<double>& other : basis_)
            subtractPart(other, q);
        const double norm = std::sqrt(dot(q, q));
        if (!(norm > LEAST_NORM * before))
            continue;
        for (double& value : q)
            value /= norm;
        followed_.push_back(weightedSum(lattice, rows, q));
        basis_.push_back(q);
    }
}

double RowGroup::project(std::vector<double>& residuals) const
{
    CV_Assert(residuals.size() == rows_.size());
    for (const std::vector<double>& q : basis_)
        subtractPart(q, residuals);
    return dot(residuals, residuals);
}

} // namespace gcpw
} // namespace cv
