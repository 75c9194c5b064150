// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#include "color/tone_limits.hpp"

#include <algorithm>
#include <opencv2/core/utility.hpp>

namespace cv
{
namespace gcpw
{

namespace
{

const int ROUNDS = 8;  ///< of limits and means in turn: each raises what the other lowers, less every time
const int SPREADS = 2; ///< over neighbours, then over other images
/// Of what a quad needs, per quad away from it: less takes the contrast of whole photographs for one lamp.
const double SLOPE = 5.0 / 255;
const double DARKEST_MEAN = 0.02; ///< of a photograph that can be scaled
const double TINT = 4.5 / 255;    ///< of a quad against its image: more is seen

typedef std::vector<ToneNeed> Needs; ///< of the quads of an image

void raise(ToneNeed& need, const ToneNeed& other)
{
    need.lift = std::max(need.lift, other.lift - SLOPE);
    need.lower = std::max(need.lower, other.lower - SLOPE);
}

/// Forward and backward over the quads, as a distance transform does.
void spread(const Lattice& lattice, Needs& needs)
{
    std::array<int, 8> neighbours{};
    const auto visit = [&](int cell, bool before)
    {
        const int count = lattice.neighbours(cell, neighbours);
        for (int k = 0; k < count; ++k)
            if ((neighbours[k] < cell) == before)
                raise(needs[cell], needs[neighbours[k]]);
    };
    for (int cell = 0; cell < lattice.cellCount(); ++cell)
        visit(cell, true);
    for (int cell = lattice.cellCount() - 1; cell >= 0; --cell)
        visit(cell, false);
}

void meet(const Needs& needs, ColorGrid& colors)
{
    for (size_t cell = 0; cell < needs.size(); ++cell)
    {
        ChannelAffine& luma = colors.quad(static_cast<int>(cell))[0];
        const double contrast = 1 - needs[cell].lift - needs[cell].lower;
        luma = {contrast * luma.gain, contrast * luma.bias + needs[cell].lift};
    }
}

/// Holds every quad's change of hue close to that of its image.
void limitTint(const PhotographTone& tone, ColorGrid& colors)
{
    const Vec3d whole = tone.change(colors) / std::max(tone.pixels(), 1.0);
    for (int cell = 0; cell < colors.lattice().cellCount(); ++cell)
    {
        if (!(tone.pixels(cell) > 0))
            continue;
        const Vec3d own = tone.change(cell, colors.quad(cell)) / tone.pixels(cell);
        for (int c = 1; c < CHANNELS; ++c)
        {
            const double tint = own[c] - whole[c];
            colors.quad(cell)[c].bias -= tint - std::min(std::max(tint, -TINT), TINT);
        }
    }
}

/// The colours with the extremes of all images limited.
std::vector<ColorGrid> limited(const std::vector<PhotographTone>& tones,
                               const std::vector<ColorComparison>& comparisons, const ToneGauge& gauge,
                               std::vector<ColorGrid> colors)
{
    const std::vector<bool>& fixed = gauge.fixed;
    const bool keep_saturated = !gauge.hasReference();
    std::vector<Needs> needs(tones.size());
    parallel_for_(Range(0, static_cast<int>(tones.size())),
                  [&](const Range& range)
                  {
        for (int i = range.start; i < range.end; ++i)
            needs[i] = fixed[i] ? Needs(colors[i].lattice().cellCount()) : tones[i].needs(colors[i], keep_saturated);
    });
    for (int k = 0; k < SPREADS; ++k)
    {
        for (const ColorComparison& comparison : comparisons)
            for (const QuadColors& quads : comparison.quads)
            {
                ToneNeed& source = needs[comparison.source_image][quads.source_cell];
                ToneNeed& target = needs[comparison.target_image][quads.target_cell];
                raise(source, target);
                raise(target, source);
            }
        for (size_t i = 0; i < tones.size(); ++i)
            spread(colors[i].lattice(), needs[i]);
    }
    for (size_t i = 0; i < tones.size(); ++i)
        if (!fixed[i])
            meet(needs[i], colors[i]);
    return colors;
}

/// Mean change of the images of a group; 0 where one is fixed, and of hue that is gray.
Vec3d meanChange(int group, const std::vector<PhotographTone>& tones, const ToneGauge& gauge,
                 const std::vector<ColorGrid>& colors)
{
    Vec3d change;
    Vec3d pixels;
    for (size_t i = 0; i < tones.size(); ++i)
    {
        if (gauge.group[i] != group)
            continue;
        if (gauge.fixed[i])
            return {};
        const Vec3d own = tones[i].change(colors[i]);
        for (int c = 0; c < (gauge.gray[i] ? 1 : CHANNELS); ++c)
        {
            change[c] += own[c];
            pixels[c] += tones[i].pixels();
        }
    }
    for (int c = 0; c < CHANNELS; ++c)
        change[c] /= std::max(pixels[c], 1.0);
    return change;
}

/// Scales Y, so that black stays black, and shifts Cr and Cb of `colors` by what `shown` has changed by.
void keepMeans(const std::vector<PhotographTone>& tones, const ToneGauge& gauge, const std::vector<ColorGrid>& shown,
               std::vector<ColorGrid>& colors)
{
    const int count = static_cast<int>(tones.size());
    for (int group = 0; group < count; ++group)
    {
        const Vec3d change = meanChange(group, tones, gauge, shown);
        double light = 0;
        double pixels = 0;
        for (int i = 0; i < count; ++i)
            if (gauge.group[i] == group)
            {
                light += tones[i].light();
                pixels += tones[i].pixels();
            }
        const double factor = 1 - change[0] / std::max(light / std::max(pixels, 1.0) + change[0], DARKEST_MEAN);
        for (int i = 0; i < count; ++i)
            for (int cell = 0; gauge.group[i] == group && cell < colors[i].lattice().cellCount(); ++cell)
            {
                ColorGrid::Quad& map = colors[i].quad(cell);
                map[0] = {factor * map[0].gain, factor * map[0].bias};
                for (int c = 1; c < (gauge.gray[i] ? 1 : CHANNELS); ++c)
                    map[c].bias -= change[c];
            }
    }
}

} // namespace

void limitTones(const std::vector<PhotographTone>& tones, const std::vector<ColorComparison>& comparisons,
                const ToneGauge& gauge, std::vector<ColorGrid>& colors)
{
    for (size_t i = 0; i < tones.size(); ++i)
        if (!gauge.fixed[i])
            limitTint(tones[i], colors[i]);
    keepMeans(tones, gauge, colors, colors);
    std::vector<ColorGrid> shown = limited(tones, comparisons, gauge, colors);
    for (int round = 1; round < ROUNDS; ++round)
    {
        keepMeans(tones, gauge, shown, colors);
        shown = limited(tones, comparisons, gauge, colors);
    }
    colors = shown;
}

void limitExtremes(const PhotographTone& tone, ColorGrid& colors)
{
    Needs needs = tone.needs(colors, false);
    spread(colors.lattice(), needs);
    meet(needs, colors);
}

} // namespace gcpw
} // namespace cv
