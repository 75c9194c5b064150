// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#ifndef OPENCV_GCPW_CORRELATION_HPP
#define OPENCV_GCPW_CORRELATION_HPP

#include <vector>
#include "overlap/overlap_samples.hpp"

namespace cv
{
namespace gcpw
{

/// How little the two images of an overlap correlate in a quad of the source.
struct QuadDecorrelation
{
    double sum = 0; ///< of (1 - correlation)^2 over the textured quarters of the quad, times their samples
    int samples = 0;
};

/// One for each quad of the source.
std::vector<QuadDecorrelation> quadDecorrelations(const OverlapSamples& samples, const State& state);

/** @brief The quads in which one state aligns the images worse than another does.

Measured by plain correlation around each quad, which neither a colour model nor a compressed mesh can improve. What moves
or changes between the photographs attracts the photometric term to wrong places; this measure shows it.
@param state the present state  @param other the state to compare with
@param ratio how much worse counts, >= 1 */
std::vector<int> worseQuads(const OverlapSamples& samples, const State& state, const State& other, double ratio);

} // namespace gcpw
} // namespace cv

#endif
