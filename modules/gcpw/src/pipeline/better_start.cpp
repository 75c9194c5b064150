// Part of the GCPW module for OpenCV. Licence: Apache-2.0 (see LICENSE).
#include "pipeline/better_start.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include "pipeline/decorrelation.hpp"

namespace cv
{
namespace gcpw
{

namespace
{

/// Of a vertex, as a share of its image's diagonal. Of 25 pairs with strong parallax the largest is 0.18; alignments that
/// matches had carried away reach 0.3 and more.
const double MAX_MOVE = 0.3;
/// Decorrelation (Score::zncc / 100) below which two alignments are equal: the rounding of 8-bit images alone makes as much.
const double ROUNDING = 1e-3;

bool inProportion(const Problem& problem, const std::vector<ImageState>& states)
{
    for (size_t i = 0; i < states.size(); ++i)
    {
        const Size size = states[i].mesh.lattice().imageSize();
        // Written so that NaN is refused.
        if (!(maxVertexDistance(states[i].mesh, problem.images[i].rough) <= MAX_MOVE * std::hypot(size.width, size.height)))
            return false;
    }
    return true;
}

/// Over all pairs; NaN where nothing can be compared.
double overall(const Problem& problem, const std::vector<ImageState>& states)
{
    Decorrelation sum;
    for (const Decorrelation& pair : decorrelations(problem, states))
        sum.add(pair);
    return sum.rms();
}

} // namespace

Candidate bestCandidate(const Problem& problem, const std::vector<ImageState>& end, const std::vector<ImageState>& matches,
                        const std::vector<ImageState>& rough)
{
    const double rough_miss = overall(problem, rough);
    const auto judged = [&](const std::vector<ImageState>& states)
    {
        const double never = std::numeric_limits<double>::infinity();
        if (!inProportion(problem, states))
            return never;
        if (std::isnan(rough_miss))
            return 0.0;
        const double miss = overall(problem, states);
        return std::isnan(miss) ? never : miss;
    };
    // Equal to the last bit of an 8-bit image is no worse.
    const auto noWorse = [](double a, double b) { return a < std::numeric_limits<double>::infinity() && a <= std::max(b, ROUNDING); };
    const double end_miss = judged(end);
    const double matches_miss = judged(matches);
    if (noWorse(end_miss, matches_miss) && noWorse(end_miss, rough_miss))
        return Candidate::END;
    return noWorse(matches_miss, rough_miss) ? Candidate::MATCHES : Candidate::ROUGH;
}

} // namespace gcpw
} // namespace cv
