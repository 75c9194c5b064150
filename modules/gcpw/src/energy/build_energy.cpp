// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#include "energy/build_energy.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include "energy/anchor_term.hpp"
#include "energy/color_smoothness_term.hpp"
#include "energy/line_term.hpp"
#include "energy/outside_term.hpp"
#include "energy/photometric_term.hpp"
#include "energy/point_term.hpp"
#include "energy/similarity_term.hpp"
#include "energy/straightness_term.hpp"

namespace cv
{
namespace gcpw
{

namespace
{

const double STRAIGHT_STEP = 4; ///< px from sample to sample of a curve that is to stay straight: several in every quad
const double OUTSIDE = 0.1; ///< of the diagonal: how far from the overlap outsideWeight counts once
const double DEVIATION = 0.1; ///< of the weighted residual of a sample that fits: the unit of robustScale

RobustLoss lossOf(double scale)
{
    return RobustLoss(scale > 0 ? scale : std::numeric_limits<double>::infinity());
}

bool isAtLeast(Method method, Method least)
{
    return static_cast<int>(method) >= static_cast<int>(least);
}

/// The terms of two images: their matches and, on a level with pixels, their overlap.
void addPair(const Problem& problem, size_t k, const Params& params, const EnergyStage& stage, Energy& energy)
{
    const ProblemPair& pair = problem.pairs[k];
    const Lattice& a = problem.images[pair.a].rough.lattice();
    const Lattice& b = problem.images[pair.b].rough.lattice();
    const RobustLoss match_loss = lossOf(stage.match_scale);
    if (hasPoints(params.method))
        energy.add(std::make_unique<PointTerm>(pair.a, pair.b, a, b, pair.matches.points, params.geometricWeight, match_loss, pair.shift_b));
    if (hasLines(params.method))
        energy.add(std::make_unique<LineTerm>(pair.a, pair.b, a, b, pair.matches.lines, params.lineStep, params.geometricWeight,
                                              match_loss, pair.shift_b));
    if (stage.overlaps.empty())
        return;
    PhotometricTerm::Options options;
    options.weight = params.photometricWeight;
    options.gain_support = hasColors(params.method) ? params.gainSupport : 0;
    options.target_moves = !problem.images[pair.b].fixed;
    // Misaligned regions look like outliers: on coarse levels, which have to move them, the loss is wider.
    options.loss = lossOf(DEVIATION * params.robustScale * stage.scale);
    const std::vector<int> anchored = stage.anchors.empty() ? std::vector<int>() : stage.anchors[k].cells;
    energy.add(std::make_unique<PhotometricTerm>(stage.overlaps[k], options, anchored));
    if (!anchored.empty())
        energy.add(std::make_unique<AnchorTerm>(pair.a, stage.anchors[k].mesh, anchored, params.anchorWeight));
}

/// How many other images an image overlaps: each pulls at it, so each also brings its share of what keeps its shape.
int neighbourCount(const Problem& problem, int image)
{
    std::vector<int> others;
    for (const ProblemPair& pair : problem.pairs)
        if (pair.a == image || pair.b == image)
            others.push_back(pair.a == image ? pair.b : pair.a);
    std::sort(others.begin(), others.end());
    return static_cast<int>(std::unique(others.begin(), others.end()) - others.begin());
}

/// Of every quad: from 0 at the overlap to 1 at OUTSIDE of the diagonal from it, and so on.
std::vector<double> outsideWeights(const ProblemImage& image)
{
    const Size size = image.rough.lattice().imageSize();
    std::vector<double> weights = image.outside;
    for (double& weight : weights)
        weight /= OUTSIDE * std::hypot(size.width, size.height);
    return weights;
}

/// The terms that keep the shape of an image.
void addShape(const Problem& problem, int image, const Params& params, Energy& energy)
{
    const MeshGrid& rough = problem.images[image].rough;
    // Of many images each neighbour pulls, so each brings its share of similarity; then stretch has to matter sooner, too.
    const double pulls = std::max(neighbourCount(problem, image), 1);
    energy.add(std::make_unique<SimilarityTerm>(image, rough, params.similarityWeight * pulls, params.stretchLimit / std::sqrt(pulls)));
    if (params.outsideWeight > 0 && !problem.images[image].outside.empty())
        energy.add(std::make_unique<OutsideTerm>(image, rough, outsideWeights(problem.images[image]), params.outsideWeight));
    if (params.straightnessWeight > 0 && !problem.images[image].straight.empty())
        energy.add(std::make_unique<StraightnessTerm>(image, rough, problem.images[image].straight, STRAIGHT_STEP,
                                                      params.straightnessWeight));
    if (!problem.hasManyImages() || params.restWeight == 0)
        return;
    std::vector<int> cells(rough.lattice().cellCount());
    std::iota(cells.begin(), cells.end(), 0);
    energy.add(std::make_unique<AnchorTerm>(image, rough, cells, params.restWeight, "shape_prior"));
}

} // namespace

bool hasPoints(Method method)
{
    return isAtLeast(method, Method::CPW);
}

bool hasLines(Method method)
{
    return isAtLeast(method, Method::DFW);
}

bool hasPixels(Method method)
{
    return isAtLeast(method, Method::MFW);
}

bool hasColors(Method method)
{
    return isAtLeast(method, Method::GCPW);
}

Energy buildEnergy(const Problem& problem, const Params& params, const EnergyStage& stage)
{
    Energy energy;
    for (size_t k = 0; k < problem.pairs.size(); ++k)
        addPair(problem, k, params, stage, energy);
    for (int i = 0; i < static_cast<int>(problem.images.size()); ++i)
    {
        if (!problem.images[i].fixed)
            addShape(problem, i, params, energy);
        if (stage.color_priors.empty())
            continue;
        energy.add(std::make_unique<ColorSmoothnessTerm>(i, problem.images[i].rough.lattice(), params.colorSmoothnessWeight));
        energy.add(std::make_unique<ColorPriorTerm>(i, stage.color_priors[i]));
    }
    return energy;
}

} // namespace gcpw
} // namespace cv
