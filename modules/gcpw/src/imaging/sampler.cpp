// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#include "imaging/sampler.hpp"

#include "imaging/wide_vectors.hpp"

namespace cv
{
namespace gcpw
{

namespace
{

const float INSIDE = 0.98F; ///< least mask value that counts as inside; pyrDown blurs the mask

/// Four channels of four neighbours, mixed by bilinear weights. Written so that compilers use one vector a pixel.
inline void mix(const float* a, const float* b, const float* c, const float* d, const float w[4], float out[4])
{
    for (int k = 0; k < 4; ++k)
        out[k] = w[0] * a[k] + w[1] * b[k] + w[2] * c[k] + w[3] * d[k];
}

/// The four pixels around a position that lies inside, and their weights.
struct Footprint
{
    int col;
    int row;
    float weight[4];

    /// False where the gradient's 4 x 4 neighbourhood leaves the image.
    bool find(const PyramidLevel& level, Point2d reference_px)
    {
        const double scale = 1 / level.scale;
        const double x = reference_px.x * scale;
        const double y = reference_px.y * scale;
        // Written so that NaN is refused too.
        if (!(x >= 1 && y >= 1 && x < level.pixels.cols - 2 && y < level.pixels.rows - 2))
            return false;
        col = static_cast<int>(x);
        row = static_cast<int>(y);
        const float u = static_cast<float>(x - col);
        const float v = static_cast<float>(y - row);
        weight[0] = (1 - u) * (1 - v);
        weight[1] = u * (1 - v);
        weight[2] = (1 - u) * v;
        weight[3] = u * v;
        return true;
    }
};

} // namespace

GCPW_WIDE_VECTORS bool sampleValue(const PyramidLevel& level, Point2d reference_px, PixelSample& sample)
{
    Footprint at;
    if (!at.find(level, reference_px))
        return false;
    const float* top = level.at(at.col, at.row);
    const float* bottom = level.at(at.col, at.row + 1);
    float value[4];
    mix(top, top + 4, bottom, bottom + 4, at.weight, value);
    if (value[3] < INSIDE)
        return false;
    for (int c = 0; c < 3; ++c)
        sample.value[c] = value[c];
    return true;
}

GCPW_WIDE_VECTORS bool samplePixel(const PyramidLevel& level, Point2d reference_px, PixelSample& sample)
{
    Footprint at;
    if (!at.find(level, reference_px))
        return false;
    const float* w = at.weight;
    const float* above = level.at(at.col, at.row - 1);
    const float* top = level.at(at.col, at.row);
    const float* bottom = level.at(at.col, at.row + 1);
    const float* below = level.at(at.col, at.row + 2);
    float value[4];
    mix(top, top + 4, bottom, bottom + 4, w, value);
    if (value[3] < INSIDE)
        return false;
    float left[4];
    float right[4];
    float up[4];
    float down[4];
    mix(top - 4, top, bottom - 4, bottom, w, left);
    mix(top + 4, top + 8, bottom + 4, bottom + 8, w, right);
    mix(above, above + 4, top, top + 4, w, up);
    mix(bottom, bottom + 4, below, below + 4, w, down);
    const float half = static_cast<float>(0.5 / level.scale);
    for (int c = 0; c < 3; ++c)
    {
        sample.value[c] = value[c];
        sample.dx[c] = half * (right[c] - left[c]);
        sample.dy[c] = half * (down[c] - up[c]);
    }
    return true;
}

bool sampleLuma(const PyramidLevel& level, Point2d reference_px, double& luma)
{
    const double x = reference_px.x / level.scale;
    const double y = reference_px.y / level.scale;
    // Written so that NaN is refused too.
    if (!(x >= 0 && y >= 0 && x < level.pixels.cols - 1 && y < level.pixels.rows - 1))
        return false;
    const int col = static_cast<int>(x);
    const int row = static_cast<int>(y);
    const double u = x - col;
    const double v = y - row;
    const float* top = level.at(col, row);
    const float* bottom = level.at(col, row + 1);
    const double w[4] = {(1 - u) * (1 - v), u * (1 - v), (1 - u) * v, u * v};
    if (w[0] * top[3] + w[1] * top[7] + w[2] * bottom[3] + w[3] * bottom[7] < INSIDE)
        return false;
    luma = w[0] * top[0] + w[1] * top[4] + w[2] * bottom[0] + w[3] * bottom[4];
    return true;
}

} // namespace gcpw
} // namespace cv
