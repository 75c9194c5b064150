// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#include "optimization/best_candidate.hpp"

#include <algorithm>
#include <cmath>

namespace cv
{
namespace gcpw
{

namespace
{

/// Of a vertex, as a share of its image's diagonal. Of 25 pairs with strong parallax the largest is 0.18; alignments
/// that wrong matches distorted reach 0.3 and more.
const double MAX_MOVE = 0.3;
/// Decorrelation (Score::zncc / 100) below which two alignments are equal: the rounding of 8-bit images alone makes as much.
const double ROUNDING = 1e-3;

/// How much better than the rough alignment a refinement has to be: as a ratio, and in decorrelation at the least. Of 1,000
/// random scenes 8 whose rendered zncc had risen by more than 2 % had gained less than this, most of them nearly perfect before.
const double WORTH_IT = 0.95;
const double LEAST_GAIN = 0.003;
/// The same ratio of the matches' meshes, which the pixels did not confirm. leuvenA/B with few matches gained 7 % and grew by 6 %.
const double UNCONFIRMED = 0.9;
/// Distortion (distortionOf()) that costs nothing. Of 16 pairs with strong parallax eleven that look right have less, and five that
/// line up much better for it, up to 0.22.
const double FREE_DISTORTION = 0.1;
/// Decorrelation (Score::zncc / 100) of a rough alignment that leaves nothing to refine: what noise and resampling make.
const double ALIGNED = 0.03;
/// The end gives way to the matches only if it is worse by this much: a preference, not the
/// strict rule that protects the rough alignment, and the comparison of patches is good to a few per cent.
const double CLEARLY_WORSE = 1.05;

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
double overall(const std::vector<Decorrelation>& pairs)
{
    Decorrelation sum;
    for (const Decorrelation& pair : pairs)
        sum.add(pair);
    return sum.rms();
}

/// A candidate and how well the images correlate by it.
struct Comparison
{
    std::vector<Decorrelation> pairs;
    bool possible = false;
    double decorrelation = 0;
    double price = 0; ///< of its distortion, as a share of the rough alignment's decorrelation
};

Comparison compare(const Problem& problem, const std::vector<ImageState>& states, bool nothing_to_compare,
                   double distortion_price)
{
    Comparison result;
    result.price = distortion_price * std::max(distortionOf(problem, states) - FREE_DISTORTION, 0.0);
    result.pairs = decorrelations(problem, states);
    const double decorrelation = overall(result.pairs);
    result.possible = inProportion(problem, states) && (nothing_to_compare || !std::isnan(decorrelation));
    result.decorrelation = nothing_to_compare ? 0 : decorrelation;
    return result;
}

bool noWorse(const Comparison& a, const Comparison& b, double ratio)
{
    return a.possible && (!b.possible || a.decorrelation <= std::max(ratio * b.decorrelation, ROUNDING));
}

bool isWorthIt(const Comparison& refined, const Comparison& rough, double ratio)
{
    const double share = ratio - refined.price;
    return refined.possible && refined.decorrelation <= std::max(share * rough.decorrelation - LEAST_GAIN, ROUNDING);
}

/// ln(s1 / s2) of the singular values of a map that keeps orientation; that of a map without area is endless.
double stretchOf(const Matx22d& map)
{
    // (s1^2 + s2^2) / (2 s1 s2) is the hyperbolic cosine of it.
    return std::acosh(std::max(0.5 * map.dot(map) / std::abs(determinant(map)), 1.0));
}

} // namespace

double distortionOf(const Problem& problem, const std::vector<ImageState>& states)
{
    double squares = 0;
    double quads = 0;
    for (size_t i = 0; i < states.size(); ++i)
        for (int cell = 0; !problem.images[i].fixed && cell < states[i].mesh.lattice().cellCount(); ++cell)
        {
            CellPoint middle;
            middle.cell = cell;
            middle.weight = bilinearWeights(0.5, 0.5);
            const double stretch =
                stretchOf(states[i].mesh.jacobian(middle) * problem.images[i].rough.jacobian(middle).inv());
            squares += stretch * stretch;
            quads += 1;
        }
    return quads > 0 ? std::sqrt(squares / quads) : 0;
}

Choice bestCandidate(const Problem& problem, const std::vector<ImageState>& end, const std::vector<ImageState>& matches,
                     const std::vector<ImageState>& rough, double distortion_price)
{
    Comparison start;
    start.pairs = decorrelations(problem, rough);
    start.possible = true;
    start.decorrelation = overall(start.pairs);
    const bool nothing_to_compare = std::isnan(start.decorrelation);
    start.decorrelation = nothing_to_compare ? 0 : start.decorrelation;
    const Comparison matched = compare(problem, matches, nothing_to_compare, distortion_price);
    const Comparison ended = compare(problem, end, nothing_to_compare, distortion_price);
    Choice choice;
    choice.before = start.pairs;
    choice.rough_is_aligned = !nothing_to_compare && start.decorrelation < ALIGNED;
    if (noWorse(ended, matched, CLEARLY_WORSE) && isWorthIt(ended, start, WORTH_IT))
    {
        choice.after = ended.pairs;
        return choice;
    }
    choice.best = isWorthIt(matched, start, UNCONFIRMED) ? Candidate::MATCHES : Candidate::ROUGH;
    choice.after = choice.best == Candidate::MATCHES ? matched.pairs : start.pairs;
    return choice;
}

} // namespace gcpw
} // namespace cv
