// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#include "api/estimate_colors.hpp"

#include "color/color_balance.hpp"
#include "imaging/photograph.hpp"
#include "imaging/pyramid.hpp"
#include "registration/image_graph.hpp"

namespace cv
{
namespace gcpw
{

std::vector<Mat> estimateColors(const std::vector<Point>& corners, const std::vector<Mat>& images,
                                const std::vector<Mat>& masks, const Params& params)
{
    std::vector<ImageState> states(images.size());
    std::vector<PyramidLevel> levels;
    for (size_t i = 0; i < images.size(); ++i)
    {
        const Lattice lattice(images[i].size(), params.meshCols, params.meshRows);
        states[i].mesh = MeshGrid(lattice, corners[i]);
        states[i].color = ColorGrid(lattice);
        levels.push_back(buildPyramid(toPhotograph(images[i], format("%zu-th", i).c_str()).image, masks[i], 1).front());
    }
    std::vector<OverlapSamples> overlaps;
    for (const Overlap& overlap : findOverlaps(corners, masks))
        overlaps.emplace_back(overlap.a, overlap.b, levels[overlap.a], levels[overlap.b], states[overlap.a].mesh.lattice(), params.sampleStep);
    std::vector<Mat> colors;
    for (const ColorGrid& grid : balancedColors(levels, overlaps, states, params.referenceImage, params))
        colors.push_back(grid.toMat());
    return colors;
}

} // namespace gcpw
} // namespace cv
