// Part of the GCPW module for OpenCV. Licence: Apache-2.0 (see LICENSE).
#include "pipeline/color_only.hpp"

#include "imaging/photograph.hpp"
#include "color/color_balance.hpp"
#include "pipeline/image_graph.hpp"
#include "pipeline/level_terms.hpp"
#include "pipeline/result.hpp"

namespace cv
{
namespace gcpw
{

namespace
{

Problem standingProblem(const std::vector<Point>& corners, const std::vector<Mat>& images, const std::vector<Mat>& masks,
                        const Params& params, const std::vector<Overlap>& overlaps)
{
    Problem problem;
    problem.images.resize(images.size());
    for (size_t i = 0; i < images.size(); ++i)
    {
        const Photograph photograph = toPhotograph(images[i], format("%zu-th", i).c_str());
        problem.images[i].rough = MeshGrid(Lattice(images[i].size(), params.meshCols, params.meshRows), corners[i]);
        problem.images[i].pyramid = buildPyramid(photograph.image, masks[i], 1);
    }
    for (const Overlap& overlap : overlaps)
    {
        ProblemPair pair;
        pair.a = overlap.a;
        pair.b = overlap.b;
        problem.pairs.push_back(pair);
    }
    return problem;
}

} // namespace

std::vector<Mat> estimateColors(const std::vector<Point>& corners, const std::vector<Mat>& images,
                                const std::vector<Mat>& masks, const Params& params)
{
    const std::vector<Overlap> overlaps = findOverlaps(corners, masks);
    const Problem problem = standingProblem(corners, images, masks, params, overlaps);
    std::vector<ImageState> states = roughStates(problem);
    std::vector<ColorGrid> grids;
    for (const ImageState& state : states)
        grids.push_back(state.color);
    if (!overlaps.empty())
    {
        Recipe recipe;
        recipe.pixels = recipe.colors = true;
        LevelTerms terms(problem, recipe, params);
        terms.enterLevel(0);
        grids = balancedColors(terms.pixels(), states, params);
    }
    std::vector<Mat> colors;
    for (const ColorGrid& grid : grids)
        colors.push_back(grid.toMat());
    return colors;
}

} // namespace gcpw
} // namespace cv
