// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#ifndef OPENCV_GCPW_FOLD_CONSTRAINT_HPP
#define OPENCV_GCPW_FOLD_CONSTRAINT_HPP

#include <vector>
#include "model/mesh_grid.hpp"
#include "solver/normal_equations.hpp"

namespace cv
{
namespace gcpw
{

/** @brief Keeps a mesh one-to-one: no corner of a quad may shrink below a fraction of its area in the rough mesh.

A bilinear quad folds exactly where the triangle at one of its corners turns over; with every corner above a positive
bound no step that passes shorten() can ever lead to a fold. Quads that a step would fold are damped first: a step then costs
the similarity energy of its *change* as well, which shortens it there and leaves energy and gradient alone. */
class FoldConstraint
{
public:
    /** @param min_ratio least area of a corner as a fraction of its rough area
    @param image index of the mesh in the equations  @param damping_weight of the similarity of a change, before it is raised */
    FoldConstraint(const MeshGrid& rough, double min_ratio, int image = 0, double damping_weight = 1);

    /** @brief The quads that a step would bring below the bound.

    Area is quadratic in the step: one that is legal as a whole need not be so half way. */
    std::vector<int> violated(const MeshGrid& mesh, const std::vector<Point2d>& step) const;

    /// Shortens the step of the vertices around violated quads, and of no others, until nothing is violated.
    void shorten(const MeshGrid& mesh, std::vector<Point2d>& step) const;

    /// Ends all damping.
    void relax();

    /// Damps a quad more firmly, up to a limit, and adds what that changes.
    void damp(int cell, MeshEquations& equations);

    /// Adds the damping of all quads.
    void addTo(MeshEquations& equations) const;

private:
    void addDamping(int cell, double factor, MeshEquations& equations) const;

    MeshGrid rough_;
    int image_;
    double damping_weight_;
    std::vector<double> bound_;  ///< four per quad
    std::vector<double> factor_; ///< of a quad's damping; 1: none
};

} // namespace gcpw
} // namespace cv

#endif
