// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#include "solver/projected_rows.hpp"

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

} // namespace

ProjectedRows projectOut(const std::vector<GroupRow>& rows)
{
    ProjectedRows result;
    for (const GroupRow& row : rows)
        result.residuals.push_back(row.residual);
    for (int column = 0; column < 2; ++column)
    {
        std::vector<double> q;
        for (const GroupRow& row : rows)
            q.push_back(row.shared[column]);
        const double before = std::sqrt(dot(q, q));
        for (const std::vector<double>& other : result.basis)
            subtractPart(other, q);
        const double norm = std::sqrt(dot(q, q));
        if (!(norm > LEAST_NORM * before))
            continue;
        for (double& value : q)
            value /= norm;
        subtractPart(q, result.residuals);
        result.basis.push_back(q);
    }
    return result;
}

} // namespace gcpw
} // namespace cv
