// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#include "overlap/outside_distance.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace cv
{
namespace gcpw
{

namespace
{

Point2d centreOf(const Lattice& lattice, int cell)
{
    return 0.5 * (lattice.referenceVertex(lattice.vertexOf(cell, 0)) + lattice.referenceVertex(lattice.vertexOf(cell, 3)));
}

} // namespace

std::vector<double> distanceOutside(const MeshGrid& mesh, const std::vector<Neighbour>& neighbours)
{
    const Lattice& lattice = mesh.lattice();
    std::vector<Point2d> inside;
    std::vector<int> outside;
    std::vector<int> hints(neighbours.size(), -1);
    for (int cell = 0; cell < lattice.cellCount(); ++cell)
    {
        const Point2d centre = centreOf(lattice, cell);
        if (isShown(mesh.warp(centre), neighbours, hints))
            inside.push_back(centre);
        else
            outside.push_back(cell);
    }
    std::vector<double> distances(lattice.cellCount(), 0);
    if (inside.empty())
        return distances;
    for (const int cell : outside)
    {
        const Point2d centre = centreOf(lattice, cell);
        double nearest = std::numeric_limits<double>::infinity();
        for (const Point2d& other : inside)
            nearest = std::min(nearest, (centre - other).dot(centre - other));
        distances[cell] = std::sqrt(nearest);
    }
    return distances;
}

} // namespace gcpw
} // namespace cv
