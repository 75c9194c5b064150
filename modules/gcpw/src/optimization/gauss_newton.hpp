// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#ifndef OPENCV_GCPW_GAUSS_NEWTON_HPP
#define OPENCV_GCPW_GAUSS_NEWTON_HPP

#include <functional>
#include <vector>
#include "energy/energy.hpp"
#include "energy/problem.hpp"
#include "opencv2/gcpw/alignment.hpp"
#include "optimization/fold_constraint.hpp"
#include "solver/joint_system.hpp"

namespace cv
{
namespace gcpw
{

/** @brief Gauss-Newton steps with a line search on meshes and colours, for any list of terms.

No step folds a quad: the mesh is checked as it is taken. No accepted step raises the energy: terms keep the weights of their
linearisation until the line search has ended (EnergyTerm::linearize()). */
class GaussNewton
{
public:
    /// @param colors whether colours are unknowns
    GaussNewton(const Problem& problem, const Params& params, bool colors);

    /// How a run ended; of one that is Done, LevelReport::stop says by which rule.
    enum class End
    {
        Done,
        Singular,
        Cancelled
    };

    struct Rules
    {
        int max_iterations = 1;
        double stop_motion_px = 0;      ///< canvas px below which no vertex need move
        double stop_gain = 0;           ///< fraction of the energy by which a step should lower it
        bool colors = false;            ///< whether colours are solved for: their terms are in the energy
        std::function<bool()> progress; ///< called before each iteration; false cancels; may be empty
    };

    /// @param state the start; receives the result, where Singular or Cancelled the last good one
    End run(Energy& energy, State& state, const Rules& rules, LevelReport& report);

    /// The colours that are best while the meshes stand still (eq. initialfunction); unchanged if NotPositiveDefinite.
    [[nodiscard]] SolveStatus solveColors(Energy& energy, State& state);

private:
    std::vector<TermEnergy> linearize(Energy& energy, const State& state);
    SolveStatus stiffenedStep(const State& state, MeshStep& step);
    MeshStep foldFree(const State& state, const MeshStep& step, double length) const;
    bool search(const Energy& energy, const MeshStep& step, const MeshStep& whole, const std::vector<ColorGrid>& colors,
                double before, State& state, std::vector<TermEnergy>& found, double& motion) const;

    const Problem& problem_;
    bool colors_;
    JointSystem system_;
    std::vector<FoldConstraint> constraints_;
};

} // namespace gcpw
} // namespace cv

#endif
