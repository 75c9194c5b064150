// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#ifndef OPENCV_GCPW_DECORRELATION_HPP
#define OPENCV_GCPW_DECORRELATION_HPP

#include <vector>
#include "model/image_state.hpp"
#include "energy/problem.hpp"

namespace cv
{
namespace gcpw
{

/** @brief How little two images correlate where they overlap: Score::zncc without rendering.

Sums over windows of 5 x 5 pixels of the source, at the working resolution whatever the mesh, that both images cover and in
which both have texture. Of a large image only patches spread evenly are read. */
struct Decorrelation
{
    double sum = 0;    ///< of (1 - zero-mean NCC)^2 of the windows, each times its area on the canvas
    double weight = 0; ///< of those areas

    void add(const Decorrelation& other)
    {
        sum += other.sum;
        weight += other.weight;
    }

    /// Root of the mean; 0 is perfect, NaN where nothing could be compared.
    double rms() const;
};

/// One for each pair of a problem. Runs on several threads; the sums do not depend on how many.
std::vector<Decorrelation> decorrelations(const Problem& problem, const std::vector<ImageState>& states);

} // namespace gcpw
} // namespace cv

#endif
