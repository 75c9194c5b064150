// Part of the GCPW module for OpenCV. Licence: Apache-2.0 (see LICENSE).
#ifndef OPENCV_GCPW_OPTIMIZER_HPP
#define OPENCV_GCPW_OPTIMIZER_HPP

#include <functional>
#include <memory>
#include "energy/joint_system.hpp"
#include "opencv2/gcpw/alignment.hpp"
#include "opencv2/gcpw/params.hpp"
#include "pipeline/fold_guard.hpp"
#include "pipeline/problem.hpp"
#include "pipeline/recipe.hpp"
#include "terms/line_term.hpp"
#include "terms/photometric_term.hpp"
#include "terms/point_term.hpp"
#include "terms/similarity_term.hpp"

namespace cv
{
namespace gcpw
{

/// Called between iterations with the share of the work done, 0..1; false cancels.
typedef std::function<bool(double)> StepCallback;

enum class OptimizeStatus
{
    Done,
    Singular, ///< the last good state is kept
    Cancelled
};

/** @brief Minimises the GCPW energy (eq. totalfunction) from coarse to fine. */
class Optimizer
{
public:
    Optimizer(const Problem& problem, const Params& params);

    /// Runs the recipe; `states` holds the start and receives the result.
    OptimizeStatus run(const Recipe& recipe, std::vector<ImageState>& states, std::vector<LevelReport>& report,
                       const StepCallback& progress);

private:
    struct Level;
    struct Poured
    {
        TermEnergies energies;
        double rest = 0; ///< all but the similarity term
    };

    Poured pour(const Level& level, const std::vector<ImageState>& states);
    OptimizeStatus runLevel(Level& level, std::vector<ImageState>& states, LevelReport& report,
                            const std::function<bool()>& keep_going);
    void setColorRest(const std::vector<PhotometricTerm>& pixels, const std::vector<ImageState>& states);
    SolveStatus guardedStep(const std::vector<ImageState>& states, const std::vector<ColorGrid>& colors, MeshStep& step);

    const Problem& problem_;
    Params params_;
    JointSystem system_;
    std::vector<SimilarityTerm> similarity_;
    std::vector<FoldGuard> guards_;
};

} // namespace gcpw
} // namespace cv

#endif
