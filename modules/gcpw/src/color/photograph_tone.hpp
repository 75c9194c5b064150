// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#ifndef OPENCV_GCPW_PHOTOGRAPH_TONE_HPP
#define OPENCV_GCPW_PHOTOGRAPH_TONE_HPP

#include <vector>
#include "imaging/pyramid.hpp"
#include "model/color_grid.hpp"

namespace cv
{
namespace gcpw
{

/// What must be done to the Y of a quad so that none of its pixels is crushed or blown: y + lift (1 - y) - lower y.
struct ToneNeed
{
    double lift = 0;
    double lower = 0;
};

/** @brief Pixels of a whole photograph, in and outside of its overlaps: what a correction does to its light. */
class PhotographTone
{
public:
    PhotographTone(const PyramidLevel& level, const Lattice& lattice);

    /** @brief What the pixels of each quad need under these colours.

    A pixel is crushed if its brightest channel falls below 24 gray levels and was not there before, or to 0; blown if its darkest
    channel rises above 250 and was not there before.
    @param keep_saturated so that no pixel's brightest channel rises far above 255 either: a saturated colour would fade to white */
    std::vector<ToneNeed> needs(const ColorGrid& colors, bool keep_saturated) const;

    /// Sum over the pixels of a quad of (corrected - photographed), per channel.
    Vec3d change(int cell, const ColorGrid::Quad& map) const;
    Vec3d change(const ColorGrid& colors) const;

    double light() const { return light_; } ///< sum of Y
    double pixels(int cell) const { return cells_[cell].pixels; }
    double pixels() const { return static_cast<double>(pixels_.size()); }

private:
    struct Pixel
    {
        int cell;
        float value[CHANNELS];
        float brightest; ///< of B, G and R
        float darkest;
    };
    struct Cell
    {
        double pixels = 0;
        Vec3d sum;
    };
    std::vector<Pixel> pixels_; ///< in the order of rows
    std::vector<Cell> cells_;
    double light_ = 0;
};

} // namespace gcpw
} // namespace cv

#endif
