// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#include "color/photograph_tone.hpp"

#include <algorithm>
#include "overlap/tone.hpp"

namespace cv
{
namespace gcpw
{

namespace
{

const int STEP = 3; ///< px: a tenth of the pixels says enough
const float DARK = 24.0F / 255;
const float MARGIN = 2.0F / 255; ///< shown bilinearly, in 8 bits, and at another resolution
const double BACK = 3; ///< of what a pixel has lost at most: one that stands within the margin already needs nothing
const float BLACK = 4.0F / 255;
const double FADED =
    25.0 / 255; ///< beyond the range: a blue sky whose blue is at its limit turns white with more of the others
const float WHITE = 250.0F / 255;
const double LEAST_REACH = 0.25; ///< of a lift or a lowering: a dark pixel is far from white, a bright one from black

} // namespace

PhotographTone::PhotographTone(const PyramidLevel& level, const Lattice& lattice) : cells_(lattice.cellCount())
{
    for (int y = STEP / 2; y < level.pixels.rows; y += STEP)
        for (int x = STEP / 2; x < level.pixels.cols; x += STEP)
        {
            const float* pixel = level.at(x, y);
            const Point2d reference(x * level.scale, y * level.scale);
            if (!(pixel[3] > 0.5F) || !lattice.contains(reference))
                continue;
            const ToneSpread spread = toneSpread(pixel[1], pixel[2]);
            const float brightest = pixel[0] + static_cast<float>(spread.above);
            const float darkest = pixel[0] - static_cast<float>(spread.below);
            const int cell = lattice.locate(reference).cell;
            pixels_.push_back({cell, {pixel[0], pixel[1], pixel[2]}, brightest, darkest});
            cells_[cell].pixels += 1;
            cells_[cell].sum += Vec3d(pixel[0], pixel[1], pixel[2]);
            light_ += pixel[0];
        }
}

std::vector<ToneNeed> PhotographTone::needs(const ColorGrid& colors, bool keep_saturated) const
{
    std::vector<ToneNeed> needs(cells_.size());
    for (const Pixel& pixel : pixels_)
    {
        const ColorGrid::Quad& map = colors.quad(pixel.cell);
        const double luma = map[0].gain * pixel.value[0] + map[0].bias;
        const ToneSpread spread =
            toneSpread(map[1].gain * pixel.value[1] + map[1].bias, map[2].gain * pixel.value[2] + map[2].bias);
        ToneNeed& need = needs[pixel.cell];
        const double brightest = luma + spread.above;
        const double darkest = luma - spread.below;
        const double lowest = pixel.brightest < DARK ? BLACK : DARK + MARGIN;
        const double missing = std::min(lowest - brightest, BACK * (pixel.brightest - brightest));
        need.lift = std::max(need.lift, missing / std::max(1 - luma, LEAST_REACH));
        if (pixel.darkest > WHITE)
            continue; // white before, white afterwards
        const double faded = keep_saturated ? brightest - std::max(1.0F, pixel.brightest) - FADED : 0;
        const double excess = std::max(faded, std::min(darkest - (WHITE - MARGIN), BACK * (darkest - pixel.darkest)));
        need.lower = std::max(need.lower, excess / std::max(luma, LEAST_REACH));
    }
    return needs;
}

Vec3d PhotographTone::change(int cell, const ColorGrid::Quad& map) const
{
    Vec3d sum;
    for (int c = 0; c < CHANNELS; ++c)
        sum[c] = (map[c].gain - 1) * cells_[cell].sum[c] + map[c].bias * cells_[cell].pixels;
    return sum;
}

Vec3d PhotographTone::change(const ColorGrid& colors) const
{
    Vec3d sum;
    for (size_t cell = 0; cell < cells_.size(); ++cell)
        sum += change(static_cast<int>(cell), colors.quad(static_cast<int>(cell)));
    return sum;
}

} // namespace gcpw
} // namespace cv
