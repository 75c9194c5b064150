// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#include "registration/match_filter.hpp"

#include "solver/mesh_system.hpp"
#include "energy/point_term.hpp"
#include "energy/similarity_term.hpp"

namespace cv
{
namespace gcpw
{

namespace
{

const double DAMPING = 1e-4; ///< weight of a vertex step, px^2: keeps vertices finite that nothing else constrains

} // namespace

MatchFilterStatus filterMatches(std::vector<PointMatch>& matches, MeshGrid& moving, const MeshGrid& rough, const MeshGrid& fixed,
                       Point2d shift_fixed, const MatchFilterSchedule& schedule)
{
    PointTerm points(0, 1, moving.lattice(), fixed.lattice(), matches, 1, RobustLoss(), shift_fixed);
    SimilarityTerm similarity(0, rough, schedule.similarity_weight);
    MeshSystem system({moving.lattice(), fixed.lattice()}, {false, true});
    State state{{moving, ColorGrid()}, {fixed, ColorGrid()}};
    MeshGrid& mesh = state[0].mesh;
    for (double scale = schedule.start_px;; scale *= schedule.factor)
    {
        points.setLoss(RobustLoss(std::max(scale, schedule.end_px)));
        system.setZero();
        system.addDamping(DAMPING);
        points.linearize(state, system);
        similarity.linearize(state, system);
        MeshStep step;
        // One image moves, so the solver is direct: anything but Solved means that there is no solution.
        if (system.solve(step) != SolveStatus::Solved)
        {
            matches.clear();
            return MatchFilterStatus::Unsolved;
        }
        mesh = moved(mesh, step[0]);
        if (scale <= schedule.end_px)
            break;
    }
    const std::vector<double> distances = points.distances(state);
    std::vector<PointMatch> kept;
    for (size_t i = 0; i < matches.size(); ++i)
        if (distances[i] <= schedule.keep_px)
            kept.push_back(matches[i]);
    matches.swap(kept);
    if (mesh.countFolds() > 0)
        return MatchFilterStatus::Folded; // as a prediction it would swap neighbouring points
    moving = mesh;
    return MatchFilterStatus::Fitted;
}

} // namespace gcpw
} // namespace cv
