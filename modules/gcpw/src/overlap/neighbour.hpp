// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#ifndef OPENCV_GCPW_NEIGHBOUR_HPP
#define OPENCV_GCPW_NEIGHBOUR_HPP

#include <vector>
#include "model/mesh_grid.hpp"

namespace cv
{
namespace gcpw
{

/// An image beside another on the canvas.
struct Neighbour
{
    const MeshGrid* mesh;
    Point2d shift; ///< canvas px by which it is seen beside its own place
};

/** @brief Whether any of the neighbours shows a canvas point.
@param hints one cell of each neighbour to start from, any value; updated
@param margin_px of each neighbour, along its border, does not count */
bool isShown(Point2d canvas, const std::vector<Neighbour>& neighbours, std::vector<int>& hints, double margin_px = 0);

} // namespace gcpw
} // namespace cv

#endif
