// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#ifndef OPENCV_GCPW_COARSE_TO_FINE_HPP
#define OPENCV_GCPW_COARSE_TO_FINE_HPP

#include <functional>
#include <vector>
#include "energy/build_energy.hpp"
#include "opencv2/gcpw/alignment.hpp"
#include "optimization/best_candidate.hpp"
#include "optimization/gauss_newton.hpp"

namespace cv
{
namespace gcpw
{

/// Called before every iteration with the fraction of the work done, 0..1; false cancels.
typedef std::function<bool(double)> StepCallback;

enum class OptimizeStatus
{
    Done,
    MatchesSingular, ///< the normal equations of the matches are singular: nothing was changed
    PixelsSingular,  ///< those of a level with pixels are: the last good state is kept
    MatchesKept,     ///< pixels made it worse: the meshes of the matches alone are kept
    RoughKept,       ///< no better than the start, whose meshes are kept
    RoughAligned,    ///< the start, which is kept, leaves nothing to refine
    Cancelled        ///< the last good state is kept
};

/** @brief Minimises the energy of a method (eq. totalfunction), coarse to fine.

1. Matches alone, their loss narrowing from wide to strict: methods without pixels end here.
2. The pyramid, coarse to fine: colours first (eq. initialfunction), then Gauss-Newton steps on meshes and colours.
3. Regions that the pixels made worse than the matches had them are anchored there, and the finest level runs again.
4. Of end, matches' meshes and start the best by correlation is kept (bestCandidate()), with colours estimated for it.
5. The colours to be shown: balancedColors(), or limitExtremes() where one of two images keeps its own. */
class CoarseToFine
{
public:
    /// @param problem must outlive this
    CoarseToFine(const Problem& problem, const Params& params);

    /// @param state the start; receives the result  @param report one entry per level run
    OptimizeStatus run(State& state, std::vector<LevelReport>& report, const StepCallback& progress);

    /// How well the pairs line up before and after run(); empty if there was nothing to choose from.
    const Choice& choice() const { return choice_; }

private:
    GaussNewton::End runStage(State& state, int max_iterations, LevelReport& report);
    GaussNewton::End fitMatches(State& state, LevelReport& report);
    OptimizeStatus runPyramid(State& state, std::vector<LevelReport>& report);
    OptimizeStatus refine(State& state, std::vector<LevelReport>& report);
    void enterLevel(int level);
    void setColorPriors(const State& state);
    void showColors(State& state) const;
    SolveStatus initColors(State& state, int passes);
    bool anchorWorse(const State& state, const State& start);

    const Problem& problem_;
    Params params_;
    bool colors_; ///< of the method
    GaussNewton solver_;
    EnergyStage stage_;
    std::vector<ColorGrid::Quad> exposures_; ///< estimated once, on the coarsest level
    StepCallback progress_;
    Choice choice_;
    int iterations_ = 0;
    int expected_iterations_ = 1;
};

} // namespace gcpw
} // namespace cv

#endif
