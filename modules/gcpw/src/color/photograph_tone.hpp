// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#ifndef OPENCV_GCPW_PHOTOGRAPH_TONE_HPP
#define OPENCV_GCPW_PHOTOGRAPH_TONE_HPP

#include <vector>
#include "imaging/pyramid.hpp"
#include "solver/color_system.hpp"

namespace cv
{
namespace gcpw
{

/** @brief Pixels of a whole photograph, in and outside of its overlaps: what a correction does to its light. */
class PhotographTone
{
public:
    PhotographTone(const PyramidLevel& level, const Lattice& lattice);

    /** @brief Adds weight * (G Y + B - limit)^2 for each pixel that the present colours would crush or blow.

    A pixel is crushed if its brightest channel falls below 24 gray levels and was not there before, or to 0; blown if its darkest
    channel rises above 250. Pixels within the limits cost nothing: linearised at the present colours, to be repeated. */
    void addLimits(int image, const ColorGrid& colors, double weight, ColorSystem& system) const;

    /// Sum over the pixels of (corrected - photographed), per channel.
    Vec3d change(const ColorGrid& colors) const;

    double pixels() const { return static_cast<double>(pixels_.size()); }

private:
    struct Pixel
    {
        int cell;
        float value[CHANNELS];
    };
    std::vector<Pixel> pixels_; ///< in the order of rows
};

} // namespace gcpw
} // namespace cv

#endif
