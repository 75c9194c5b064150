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
const double DARK = 24.0 / 255;
const double MARGIN = 2.0 / 255; ///< shown bilinearly, and at another resolution
const double BLACK = 4.0 / 255;
const double WHITE = 250.0 / 255;

} // namespace

PhotographTone::PhotographTone(const PyramidLevel& level, const Lattice& lattice)
{
    for (int y = STEP / 2; y < level.pixels.rows; y += STEP)
        for (int x = STEP / 2; x < level.pixels.cols; x += STEP)
        {
            const float* pixel = level.at(x, y);
            const Point2d reference(x * level.scale, y * level.scale);
            if (pixel[3] > 0.5F && lattice.contains(reference))
                pixels_.push_back({lattice.locate(reference).cell, {pixel[0], pixel[1], pixel[2]}});
        }
}

void PhotographTone::addLimits(int image, const ColorGrid& colors, double weight, ColorSystem& system) const
{
    std::vector<SampleColor> blocks(colors.lattice().cellCount());
    std::vector<bool> used(blocks.size(), false);
    for (const Pixel& pixel : pixels_)
    {
        const ColorGrid::Quad& map = colors.quad(pixel.cell);
        const double y = pixel.value[0];
        const double now = map[0].gain * y + map[0].bias;
        const ToneSpread before = toneSpread(pixel.value[1], pixel.value[2]);
        const ToneSpread after = toneSpread(map[1].gain * pixel.value[1] + map[1].bias, map[2].gain * pixel.value[2] + map[2].bias);
        const double brightest = y + before.above;
        const double darkest = y - before.below;
        const double lowest = brightest >= DARK ? std::min(brightest, DARK + MARGIN) - after.above : std::min(y, BLACK);
        const double highest = darkest <= WHITE ? std::max(darkest, WHITE - MARGIN) + after.below : std::max(y, 1.0);
        const double residual = now - std::min(std::max(now, lowest), highest);
        if (residual == 0)
            continue;
        SampleColor& block = blocks[pixel.cell];
        used[pixel.cell] = true;
        block.color_color[0][0] += weight * y * y;
        block.color_color[0][1] += weight * y;
        block.color_color[0][2] += weight;
        block.color_gradient[0][0] += weight * residual * y;
        block.color_gradient[0][1] += weight * residual;
    }
    for (size_t cell = 0; cell < blocks.size(); ++cell)
        if (used[cell])
            system.addSamples({image, static_cast<int>(cell)}, blocks[cell], colors.quad(static_cast<int>(cell)));
}

Vec3d PhotographTone::change(const ColorGrid& colors) const
{
    Vec3d sum;
    for (const Pixel& pixel : pixels_)
        for (int c = 0; c < CHANNELS; ++c)
        {
            const ChannelAffine& map = colors.quad(pixel.cell)[c];
            sum[c] += map.gain * pixel.value[c] + map.bias - pixel.value[c];
        }
    return sum;
}

} // namespace gcpw
} // namespace cv
