// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#include "optimization/decorrelation.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <opencv2/core/utility.hpp>
#include "overlap/color_moments.hpp"
#include "overlap/target_lookup.hpp"

namespace cv
{
namespace gcpw
{

namespace
{

const int WINDOW = 5;             ///< px, that of Score
const double MOST_PIXELS = 150e3; ///< of an image that are read: thousands of windows tell two alignments apart
const int PATCH = 16;             ///< px, width of a patch of windows of one row
const double STAGGER = 0.618034;  ///< golden ratio: patches side by side lie at rows that fill a stride evenly
const float INSIDE = 0.98F;       ///< least mask value of a source pixel that is read

/// From one row of patches to the next; those of small images lie over each other.
int strideOf(const PyramidLevel& level)
{
    return std::max(1, cvRound(WINDOW * static_cast<double>(level.pixels.total()) / MOST_PIXELS));
}

/// (1 - zero-mean NCC)^2 of a window; false where one of the images has no texture.
bool squaredDecorrelation(const PairSums& s, double& result)
{
    const double va = s.aa - s.a * s.a / s.n;
    const double vb = s.bb - s.b * s.b / s.n;
    if (!(va > TEXTURE_VARIANCE * s.n) || !(vb > TEXTURE_VARIANCE * s.n))
        return false;
    const double z = 1 - std::min(std::max((s.ab - s.a * s.b / s.n) / std::sqrt(va * vb), -1.0), 1.0);
    result = z * z;
    return true;
}

/// Calls visit(x, canvas position) for the pixels [first, last) of a row.
template <typename Visit>
void forEachOfRow(const MeshGrid& mesh, int y, Range columns, double scale, Visit visit)
{
    const Lattice& lattice = mesh.lattice();
    const double cell_width = lattice.cellSize().width;
    const CellPoint start = lattice.locate(Point2d(columns.start * scale, y * scale));
    const double v = start.weight[2] + start.weight[3];
    int x = columns.start;
    int col = start.cell % lattice.cols();
    for (int cell = start.cell; x < columns.end; ++cell, ++col)
    {
        const Point2d left = (1 - v) * mesh.vertex(cell, 0) + v * mesh.vertex(cell, 2);
        const Point2d right = (1 - v) * mesh.vertex(cell, 1) + v * mesh.vertex(cell, 3);
        for (; x < columns.end; ++x)
        {
            const double u = (x * scale + 0.5) / cell_width - col;
            if (u > 1 && col + 1 < lattice.cols())
                break;
            visit(x, (1 - u) * left + u * right);
        }
    }
}

/// All windows of a patch: those whose first row is `top`, in some columns.
Decorrelation patch(const PyramidLevel& source, const PyramidLevel& target, const MeshGrid& mesh, TargetLookup& lookup, int top,
                    Range columns)
{
    PairSums sums[PATCH + WINDOW];
    for (int y = top; y < top + WINDOW; ++y)
        forEachOfRow(mesh, y, columns, source.scale, [&](int x, Point2d canvas)
        {
            double luma = 0;
            const float* pixel = source.at(x, y);
            if (pixel[3] >= INSIDE && lookup.find(canvas) && sampleLuma(target, lookup.reference(), luma))
                sums[x - columns.start].add(pixel[0], luma);
        });
    Decorrelation result;
    PairSums window;
    for (int i = 0; i < columns.size(); ++i)
    {
        window.add(sums[i], 1);
        if (i >= WINDOW)
            window.add(sums[i - WINDOW], -1);
        double value = 0;
        if (cvRound(window.n) != WINDOW * WINDOW || !squaredDecorrelation(window, value))
            continue;
        const Point2d centre((columns.start + i - WINDOW / 2) * source.scale, (top + WINDOW / 2) * source.scale);
        const int cell = mesh.lattice().locate(centre).cell;
        const double area = mesh.cornerArea(cell, 0) + mesh.cornerArea(cell, 3);
        result.sum += area * value;
        result.weight += area;
    }
    return result;
}

/// The windows of one row of patches.
Decorrelation row(const PyramidLevel& source, const PyramidLevel& target, const MeshGrid& mesh, TargetLookup& lookup, int first_row)
{
    const int stride = strideOf(source);
    Decorrelation result;
    for (int x = 0, k = 0; x + WINDOW <= source.pixels.cols; x += PATCH, ++k)
    {
        const double share = k * STAGGER;
        const int top = first_row + static_cast<int>(stride * (share - std::floor(share)));
        if (top + WINDOW <= source.pixels.rows)
            result.add(patch(source, target, mesh, lookup, top, Range(x, std::min(x + PATCH + WINDOW - 1, source.pixels.cols))));
    }
    return result;
}

} // namespace

double Decorrelation::rms() const
{
    return weight > 0 ? std::sqrt(sum / weight) : std::numeric_limits<double>::quiet_NaN();
}

std::vector<Decorrelation> decorrelations(const Problem& problem, const std::vector<ImageState>& states)
{
    struct Row
    {
        size_t pair;
        int first;
    };
    std::vector<Row> rows;
    for (size_t k = 0; k < problem.pairs.size(); ++k)
    {
        const PyramidLevel& level = problem.images[problem.pairs[k].a].pyramid.front();
        for (int first = 0; first + WINDOW <= level.pixels.rows; first += strideOf(level))
            rows.push_back({k, first});
    }
    std::vector<Decorrelation> parts(rows.size());
    parallel_for_(Range(0, static_cast<int>(rows.size())), [&](const Range& range)
    {
        for (int i = range.start; i < range.end; ++i)
        {
            const ProblemPair& pair = problem.pairs[rows[i].pair];
            TargetLookup lookup(states[pair.b], pair.shift_b, false);
            parts[i] = row(problem.images[pair.a].pyramid.front(), problem.images[pair.b].pyramid.front(), states[pair.a].mesh,
                           lookup, rows[i].first);
        }
    });
    std::vector<Decorrelation> result(problem.pairs.size());
    for (size_t i = 0; i < rows.size(); ++i)
        result[rows[i].pair].add(parts[i]);
    return result;
}

} // namespace gcpw
} // namespace cv
