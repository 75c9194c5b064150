// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#ifndef OPENCV_GCPW_BEST_CANDIDATE_HPP
#define OPENCV_GCPW_BEST_CANDIDATE_HPP

#include <vector>
#include "model/image_state.hpp"
#include "optimization/decorrelation.hpp"

namespace cv
{
namespace gcpw
{

/// The alignments between which a result is chosen.
enum class Candidate
{
    END,     ///< where the optimiser ended
    MATCHES, ///< where the matches alone had put the meshes
    ROUGH    ///< the rough alignment
};

/// What was chosen, and how well it and the rough alignment line up.
struct Choice
{
    Candidate best = Candidate::END;
    bool rough_is_aligned = false;     ///< the rough alignment lines up so well that there is nothing to refine
    std::vector<Decorrelation> before; ///< of the rough alignment, one for each pair
    std::vector<Decorrelation> after;  ///< of the chosen one
};

/** @brief Chooses the alignment by which the images of a problem correlate best (decorrelations() over all pairs).

The energy cannot tell: matches that are wrong together, or pixels that show something else, lower it while the picture gets
worse. The rough alignment is kept if nothing is clearly better, and the matches' meshes if the end is clearly worse than they
are; these, which the pixels did not confirm, have to gain twice as much. What changes shapes has to be better by more (Params::distortionPrice). A mesh that moved out of proportion, or after which nothing is left to compare, is never chosen; where nothing can be
compared at the rough alignment, the end is.
@param end, matches, rough the candidates
@param distortion_price see Params::distortionPrice */
Choice bestCandidate(const Problem& problem, const std::vector<ImageState>& end, const std::vector<ImageState>& matches,
                     const std::vector<ImageState>& rough, double distortion_price);

/// Root of the mean square of ln(s1 / s2) over the quads of all images that are not fixed, against the rough alignment; 0 if all are.
double distortionOf(const Problem& problem, const std::vector<ImageState>& states);

} // namespace gcpw
} // namespace cv

#endif
