// Part of the GCPW module for OpenCV. Licence: Apache-2.0 (see LICENSE).
#ifndef OPENCV_GCPW_FOLD_GUARD_HPP
#define OPENCV_GCPW_FOLD_GUARD_HPP

#include <vector>
#include "model/mesh_grid.hpp"

namespace cv
{
namespace gcpw
{

/** @brief Keeps a mesh one-to-one: no corner of a quad may shrink below a share of its area in the rough mesh.

A bilinear quad folds exactly where the triangle at one of its corners turns over; with every corner above a positive
bound no step that passes shorten() can ever lead to a fold. */
class FoldGuard
{
public:
    FoldGuard(const MeshGrid& rough, double min_share);

    /** @brief The quads that a share of a step would bring below the bound.

    Area is quadratic in the share: a step that is legal as a whole need not be so half way. */
    std::vector<int> violated(const MeshGrid& mesh, const std::vector<Point2d>& step, double share = 1) const;

    /// Shortens the step of the vertices around violated quads, and of no others, until nothing is violated.
    void shorten(const MeshGrid& mesh, std::vector<Point2d>& step) const;

private:
    std::vector<double> bound_; ///< four per quad
};

/// mesh + share * step
MeshGrid moved(const MeshGrid& mesh, const std::vector<Point2d>& step, double share);

} // namespace gcpw
} // namespace cv

#endif
