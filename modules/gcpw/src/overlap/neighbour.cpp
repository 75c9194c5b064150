// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#include "overlap/neighbour.hpp"

#include <algorithm>

namespace cv
{
namespace gcpw
{

bool isShown(Point2d canvas, const std::vector<Neighbour>& neighbours, std::vector<int>& hints, double margin_px)
{
    for (size_t k = 0; k < neighbours.size(); ++k)
    {
        CellPoint found;
        if (!neighbours[k].mesh->invert(canvas - neighbours[k].shift, hints[k], found))
            continue;
        if (margin_px == 0)
            return true;
        const Lattice& lattice = neighbours[k].mesh->lattice();
        Point2d p;
        for (int i = 0; i < 4; ++i)
            p += found.weight[i] * lattice.referenceVertex(lattice.vertexOf(found.cell, i));
        const Size size = lattice.imageSize();
        if (std::min(std::min(p.x, p.y), std::min(size.width - 1 - p.x, size.height - 1 - p.y)) >= margin_px)
            return true;
    }
    return false;
}

} // namespace gcpw
} // namespace cv
