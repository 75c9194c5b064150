// Part of the GCPW module for OpenCV. Licence: Apache-2.0 (see LICENSE).
#ifndef OPENCV_GCPW_OPTIMIZER_HPP
#define OPENCV_GCPW_OPTIMIZER_HPP

#include <functional>
#include <vector>
#include "energy/joint_system.hpp"
#include "opencv2/gcpw/alignment.hpp"
#include "pipeline/better_start.hpp"
#include "pipeline/color_rest.hpp"
#include "pipeline/fold_guard.hpp"
#include "pipeline/level_terms.hpp"
#include "terms/similarity_term.hpp"

namespace cv
{
namespace gcpw
{

/// Called before every iteration with the share of the work done, 0..1; false cancels.
typedef std::function<bool(double)> StepCallback;

enum class OptimizeStatus
{
    Done,
    MatchesSingular, ///< the matches leave the meshes free: nothing was changed
    PixelsSingular,  ///< a level with pixels had no answer: the last good state is kept
    MatchesKept,     ///< pixels made it worse: the meshes of the matches alone are kept
    RoughKept,       ///< no better than the start, whose meshes are kept
    Cancelled        ///< the last good state is kept
};

/** @brief Minimises the GCPW energy (eq. totalfunction) of a recipe.

1. Matches alone, their loss narrowing from wide to strict: methods without pixels end here.
2. The pyramid, coarse to fine: colours first (eq. initialfunction), then Gauss-Newton steps on meshes and colours.
3. Regions that the pixels made worse than the matches had them are anchored there, and the finest level runs again.
4. What correlates no better than the matches' meshes or the start gives way to them (bestCandidate()), with colours of its own.
5. Of more than two images: colours that are fit to be seen (balancedColors()).

No step folds a quad: the mesh is checked as it is taken. No accepted step raises the energy: weights that the colours of a
quad have for what its samples are worth (ColorTrust) are fixed at each linearisation, and its step is judged by the function
that was linearised. */
class Optimizer
{
public:
    /// @param problem must outlive the optimiser
    Optimizer(const Problem& problem, const Recipe& recipe, const Params& params);

    /// @param states the start; receives the result  @param report one entry per level run
    OptimizeStatus run(std::vector<ImageState>& states, std::vector<LevelReport>& report, const StepCallback& progress);

    /// How well the pairs line up before and after run(); empty if it chose between nothing.
    const Choice& choice() const { return choice_; }

private:
    enum class LevelEnd
    {
        Done,
        Singular,
        Cancelled
    };

    LevelEnd fitMatches(LevelTerms& terms, std::vector<ImageState>& states, LevelReport& report);
    OptimizeStatus refine(LevelTerms& terms, std::vector<ImageState>& states, std::vector<LevelReport>& report);
    OptimizeStatus runPyramid(LevelTerms& terms, std::vector<ImageState>& states, std::vector<LevelReport>& report);
    LevelEnd runLevel(LevelTerms& terms, std::vector<ImageState>& states, int max_iterations, LevelReport& report);
    bool anchorWorse(LevelTerms& terms, const std::vector<ImageState>& states, const std::vector<ImageState>& start) const;

    /// Energies at the state that was poured last.
    struct Poured
    {
        TermEnergies terms;
        double here = 0;  ///< of the function that is linearised there
        double fixed = 0; ///< of the function that LevelTerms::fix() had taken
    };
    Poured pour(LevelTerms& terms, const std::vector<ImageState>& states, bool compare);
    SolveStatus initColors(LevelTerms& terms, std::vector<ImageState>& states);
    SolveStatus safeStep(const std::vector<ImageState>& states, MeshStep& step);
    double take(const std::vector<ImageState>& states, const MeshStep& step, const std::vector<ColorGrid>& colors, double share,
                std::vector<ImageState>& next) const;
    bool folds(const std::vector<ImageState>& states, const MeshStep& step, double share) const;
    bool tick();

    const Problem& problem_;
    Recipe recipe_;
    Params params_;
    JointSystem system_;
    ColorRest color_rest_;
    std::vector<SimilarityTerm> similarity_;
    std::vector<FoldGuard> guards_;
    StepCallback progress_;
    Choice choice_;
    int ticks_ = 0;
    int expected_ticks_ = 1;
};

} // namespace gcpw
} // namespace cv

#endif
