// Part of the GCPW module for OpenCV. Licence: Apache-2.0 (see LICENSE).
#ifndef OPENCV_GCPW_BETTER_START_HPP
#define OPENCV_GCPW_BETTER_START_HPP

#include <vector>
#include "model/image_state.hpp"
#include "pipeline/problem.hpp"

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

/** @brief Chooses the alignment by which the images of a problem correlate best (decorrelations() over all pairs).

The energy cannot tell: matches that are wrong together, or pixels that show something else, lower it while the picture gets
worse. What is no better than an earlier candidate gives way to it. A mesh that moved out of proportion, or by which nothing
is left to be compared, is never chosen; where the rough alignment shows nothing to compare, the end is.
@param end, matches the meshes that are judged */
Candidate bestCandidate(const Problem& problem, const std::vector<ImageState>& end, const std::vector<ImageState>& matches,
                        const std::vector<ImageState>& rough);

} // namespace gcpw
} // namespace cv

#endif
