// Part of the GCPW module for OpenCV. Licence: Apache-2.0 (see LICENSE).
#include "pipeline/color_only.hpp"

#include "energy/joint_system.hpp"
#include "imaging/photograph.hpp"
#include "pipeline/color_rest.hpp"
#include "pipeline/image_graph.hpp"
#include "pipeline/level_terms.hpp"
#include "pipeline/result.hpp"
#include "terms/color_smoothness_term.hpp"

namespace cv
{
namespace gcpw
{

namespace
{

const int NO_REFERENCE = -2; ///< Params::referenceImage: no image is asked for; colours need one all the same
const int PASSES = 3;        ///< a level: what quads are trusted with depends on the colours, and settles in as many

Problem standingProblem(const std::vector<Point>& corners, const std::vector<Mat>& images, const std::vector<Mat>& masks,
                        const Params& params, const std::vector<Overlap>& overlaps)
{
    Problem problem;
    problem.images.resize(images.size());
    for (size_t i = 0; i < images.size(); ++i)
    {
        const Photograph photograph = toPhotograph(images[i], format("%zu-th", i).c_str());
        problem.images[i].rough = MeshGrid(Lattice(images[i].size(), params.meshCols, params.meshRows), corners[i]);
        problem.images[i].pyramid = buildPyramid(photograph.image, masks[i], params.pyramidLevels);
    }
    const int count = static_cast<int>(images.size());
    const int wished = params.referenceImage;
    problem.images[wished > NO_REFERENCE + 1 && wished < count ? wished : mostCentral(count, overlaps)].held = true;
    for (const Overlap& overlap : overlaps)
    {
        ProblemPair pair;
        const bool swap = problem.images[overlap.a].held; // samples lie in an image whose colour changes
        pair.a = swap ? overlap.b : overlap.a;
        pair.b = swap ? overlap.a : overlap.b;
        problem.pairs.push_back(pair);
    }
    return problem;
}

void solveLevel(LevelTerms& terms, JointSystem& system, std::vector<ImageState>& states)
{
    for (int pass = 0; pass < PASSES; ++pass)
    {
        TermEnergies energies;
        system.setZero();
        terms.pour(states, system, energies);
        std::vector<ColorGrid> colors;
        for (const ImageState& state : states)
            colors.push_back(state.color);
        if (system.solveColors(colors) == SolveStatus::NotPositiveDefinite)
            return;
        for (size_t i = 0; i < states.size(); ++i)
            states[i].color = colors[i];
    }
}

} // namespace

std::vector<Mat> estimateColors(const std::vector<Point>& corners, const std::vector<Mat>& images,
                                const std::vector<Mat>& masks, const Params& params)
{
    const std::vector<Overlap> overlaps = findOverlaps(corners, masks);
    const Problem problem = standingProblem(corners, images, masks, params, overlaps);
    std::vector<ImageState> states = roughStates(problem);
    if (!overlaps.empty())
    {
        Recipe recipe;
        recipe.pixels = recipe.colors = true;
        std::vector<Lattice> lattices;
        std::vector<bool> color_held;
        size_t levels = static_cast<size_t>(params.pyramidLevels);
        for (const ProblemImage& image : problem.images)
        {
            lattices.push_back(image.rough.lattice());
            color_held.push_back(image.held);
            levels = std::min(levels, image.pyramid.size());
        }
        JointSystem system(lattices, color_held, color_held);
        for (size_t i = 0; i < lattices.size(); ++i)
            addColorSmoothness(static_cast<int>(i), lattices[i], params.colorSmoothnessWeight, system.colors());
        // Plain squares, as in the paper: where nothing lines up there are no outliers, only differences to be evened out.
        Params plain = params;
        plain.robustScale = 0;
        LevelTerms terms(problem, recipe, plain);
        ColorRest rest(problem, params.colorRestWeight, params.exposureWeight);
        for (size_t level = levels; level-- > 0;)
        {
            terms.enterLevel(static_cast<int>(level));
            rest.pull(terms.pixels(), states, system.colors());
            solveLevel(terms, system, states);
        }
    }
    std::vector<Mat> colors;
    for (const ImageState& state : states)
        colors.push_back(state.color.toMat());
    return colors;
}

} // namespace gcpw
} // namespace cv
