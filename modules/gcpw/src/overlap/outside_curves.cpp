// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#include "overlap/outside_curves.hpp"

namespace cv
{
namespace gcpw
{

std::vector<Curve> partsOutside(const Curve& curve, const MeshGrid& mesh, const std::vector<Neighbour>& neighbours,
                                double step_px, double min_length, double margin_px)
{
    std::vector<Curve> parts;
    Curve part;
    const auto end = [&]
    {
        if (lengthOf(part) >= min_length && part.size() > 1)
            parts.push_back(part);
        part.clear();
    };
    std::vector<int> hints(neighbours.size(), -1);
    for (const Point2d& p : resampled(curve, step_px))
    {
        if (!mesh.lattice().contains(p) || isShown(mesh.warp(p), neighbours, hints, margin_px))
            end();
        else
            part.push_back(p);
    }
    end();
    return parts;
}

} // namespace gcpw
} // namespace cv
