// Part of the GCPW module for OpenCV. Licence: Apache-2.0 (see LICENSE).
#ifndef OPENCV_GCPW_BETTER_START_HPP
#define OPENCV_GCPW_BETTER_START_HPP

#include <vector>
#include "model/image_state.hpp"
#include "pipeline/decorrelation.hpp"

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
    std::vector<Decorrelation> before; ///< of the rough alignment, one for each pair
    std::vector<Decorrelation> after;  ///< of the chosen one
};

/** @brief Chooses the alignment by which the images of a problem correlate best (decorrelations() over all pairs).

The energy cannot tell: matches that are wrong together, or pixels that show something else, lower it while the picture gets
worse. What is not clearly better than the rough alignment gives way to it, and so does an end that is clearly worse than the
matches alone. A mesh that moved out of proportion, or by which nothing
is left to be compared, is never chosen; where the rough alignment shows nothing to compare, the end is.
@param end, matches the meshes that are judged */
Choice bestCandidate(const Problem& problem, const std::vector<ImageState>& end, const std::vector<ImageState>& matches,
                     const std::vector<ImageState>& rough);

} // namespace gcpw
} // namespace cv

#endif
