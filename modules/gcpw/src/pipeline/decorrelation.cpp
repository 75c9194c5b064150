// Part of the GCPW module for OpenCV. Licence: Apache-2.0 (see LICENSE).
#include "pipeline/decorrelation.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <opencv2/core/utility.hpp>
#include "terms/color_moments.hpp"
#include "terms/target_lookup.hpp"

namespace cv
{
namespace gcpw
{

namespace
{

const int WINDOW = 5;             ///< px, that of Score
const double MOST_PIXELS = 150e3; ///< of an image that are read: thousands of windows tell two alignments apart
const float INSIDE = 0.98F;       ///< least mask value of a source pixel that is read

/// From the first row of a band to that of the next; bands of small images lie over each other.
int strideOf(const PyramidLevel& level)
{
    return std::max(1, cvRound(WINDOW * static_cast<double>(level.pixels.total()) / MOST_PIXELS));
}

/// (1 - zero-mean NCC)^2 of a window; false where one of the images has no texture.
bool miss(const PairSums& s, double& result)
{
    const double va = s.aa - s.a * s.a / s.n;
    const double vb = s.bb - s.b * s.b / s.n;
    if (!(va > TEXTURE_VARIANCE * s.n) || !(vb > TEXTURE_VARIANCE * s.n))
        return false;
    const double z = 1 - std::min(std::max((s.ab - s.a * s.b / s.n) / std::sqrt(va * vb), -1.0), 1.0);
    result = z * z;
    return true;
}

/// All windows whose first row is `top`.
Decorrelation band(const PyramidLevel& source, const PyramidLevel& target, const MeshGrid& mesh, TargetLookup& lookup, int top)
{
    const Lattice& lattice = mesh.lattice();
    std::vector<PairSums> columns(source.pixels.cols);
    for (int y = top; y < top + WINDOW; ++y)
        for (int x = 0; x < source.pixels.cols; ++x)
        {
            double luma = 0;
            const float* pixel = source.at(x, y);
            if (pixel[3] >= INSIDE && lookup.find(mesh.warp(Point2d(x * source.scale, y * source.scale))) &&
                sampleLuma(target, lookup.rest(), luma))
                columns[x].add(pixel[0], luma);
        }
    Decorrelation result;
    PairSums window;
    for (int x = 0; x < source.pixels.cols; ++x)
    {
        window.add(columns[x], 1);
        if (x >= WINDOW)
            window.add(columns[x - WINDOW], -1);
        double value = 0;
        if (cvRound(window.n) != WINDOW * WINDOW || !miss(window, value))
            continue;
        const Point2d centre((x - WINDOW / 2) * source.scale, (top + WINDOW / 2) * source.scale);
        const int cell = lattice.locate(centre).cell;
        const double area = mesh.cornerArea(cell, 0) + mesh.cornerArea(cell, 3);
        result.sum += area * value;
        result.weight += area;
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
    struct Band
    {
        size_t pair;
        int top;
    };
    std::vector<Band> bands;
    for (size_t k = 0; k < problem.pairs.size(); ++k)
    {
        const PyramidLevel& level = problem.images[problem.pairs[k].a].pyramid.front();
        const int stride = strideOf(level);
        for (int top = std::max(stride - WINDOW, 0) / 2; top + WINDOW <= level.pixels.rows; top += stride)
            bands.push_back({k, top});
    }
    std::vector<Decorrelation> parts(bands.size());
    parallel_for_(Range(0, static_cast<int>(bands.size())), [&](const Range& range)
    {
        for (int i = range.start; i < range.end; ++i)
        {
            const ProblemPair& pair = problem.pairs[bands[i].pair];
            TargetLookup lookup(states[pair.b], pair.shift_b, false);
            parts[i] = band(problem.images[pair.a].pyramid.front(), problem.images[pair.b].pyramid.front(),
                            states[pair.a].mesh, lookup, bands[i].top);
        }
    });
    std::vector<Decorrelation> result(problem.pairs.size());
    for (size_t i = 0; i < bands.size(); ++i)
        result[bands[i].pair].add(parts[i]);
    return result;
}

} // namespace gcpw
} // namespace cv
