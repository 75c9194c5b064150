// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#include "energy/sample_sums.hpp"

#include <algorithm>
#include <cmath>
#include "imaging/wide_vectors.hpp"
#include "overlap/color_moments.hpp"

namespace cv
{
namespace gcpw
{

namespace
{

const double MIN_VARIANCE = 1e-6; ///< of an intensity: below is rounding of 8-bit images

/// Expands sums over pairs of corners into the upper triangle of an 8 x 8 block.
void unfold(const double (&curvature)[10][3], double weight, QuadBlock& block)
{
    int pair = 0;
    for (int k = 0; k < 4; ++k)
        for (int m = k; m < 4; ++m, ++pair)
        {
            const double* s = curvature[pair];
            block[2 * k][2 * m] = weight * s[0];
            block[2 * k][2 * m + 1] = weight * s[1];
            if (m > k)
                block[2 * k + 1][2 * m] = weight * s[1];
            block[2 * k + 1][2 * m + 1] = weight * s[2];
        }
}

struct Curvature
{
    double xx = 0;
    double xy = 0;
    double yy = 0;
};

Curvature curvatureOf(const LinearSample& s)
{
    Curvature h;
    for (int c = 0; c < 3; ++c)
    {
        h.xx += s.gx[c] * s.gx[c];
        h.xy += s.gx[c] * s.gy[c];
        h.yy += s.gy[c] * s.gy[c];
    }
    return h;
}

} // namespace

GCPW_WIDE_VECTORS void SampleSums::add(const float* corner_weight, const LinearSample& s)
{
    const Curvature h = curvatureOf(s);
    double part[14] = {};
    for (int c = 0; c < 3; ++c)
    {
        const double i = s.mine[c];
        part[0] += s.gx[c] * s.residual[c];
        part[1] += s.gy[c] * s.residual[c];
        double* own = part + 2 + 4 * c;
        own[0] = s.gx[c] * i;
        own[1] = s.gx[c];
        own[2] = s.gy[c] * i;
        own[3] = s.gy[c];
        const double w = s.weight;
        color_[c][0] += w * i * i;
        color_[c][1] += w * i;
        color_[c][2] += w;
        color_[c][3] += w * i * s.residual[c];
        color_[c][4] += w * s.residual[c];
        color_[c][5] += w * s.residual[c] * s.residual[c];
    }
    int pair = 0;
    for (int k = 0; k < 4; ++k)
    {
        const double wk = s.weight * corner_weight[k];
        for (int j = 0; j < 14; ++j)
            corner_[k][j] += wk * part[j];
        for (int m = k; m < 4; ++m, ++pair)
        {
            const double wkm = wk * corner_weight[m];
            curvature_[pair][0] += wkm * h.xx;
            curvature_[pair][1] += wkm * h.xy;
            curvature_[pair][2] += wkm * h.yy;
        }
    }
    ++samples_;
}

PhotometricBlock SampleSums::block(double weight) const
{
    // d residual / d position = -g, d residual / d (gain, bias) = (I, 1)
    PhotometricBlock block;
    unfold(curvature_, weight, block.mesh_mesh);
    for (int k = 0; k < 4; ++k)
        for (int axis = 0; axis < 2; ++axis)
        {
            block.mesh_gradient[2 * k + axis] = -weight * corner_[k][axis];
            for (int c = 0; c < 3; ++c)
                for (int j = 0; j < 2; ++j)
                    block.mesh_color[2 * k + axis][2 * c + j] = -weight * corner_[k][2 + 4 * c + 2 * axis + j];
        }
    for (int c = 0; c < 3; ++c)
    {
        for (int j = 0; j < 3; ++j)
            block.color_color[c][j] = weight * color_[c][j];
        for (int j = 0; j < 2; ++j)
            block.color_gradient[c][j] = weight * color_[c][3 + j];
    }
    block.samples = samples_;
    return block;
}

SampleSums::ChannelCorrelation SampleSums::channelCorrelation(int channel, double gain) const
{
    // The corrected target is T = G I + B - r; its moments follow from those of I and r.
    const double* s = color_[channel];
    const double mean_i = s[1] / s[2];
    const double mean_r = s[4] / s[2];
    const double cov_ir = s[3] / s[2] - mean_i * mean_r;
    ChannelCorrelation result;
    result.variance = s[0] / s[2] - mean_i * mean_i;
    result.target_variance = gain * gain * result.variance - 2 * gain * cov_ir + s[5] / s[2] - mean_r * mean_r;
    if (result.variance > MIN_VARIANCE && result.target_variance > MIN_VARIANCE)
        result.correlation = (gain * result.variance - cov_ir) / std::sqrt(result.variance * result.target_variance);
    return result;
}

void SampleSums::reweightColors(const ColorGrid::Quad& now, double weight, double support, PhotometricBlock& block,
                             FrozenWeights& fixed) const
{
    fixed.clear();
    if (!(color_[0][2] > 0))
        return;
    const ChannelCorrelation luma = channelCorrelation(0, now[0].gain);
    const double correlation_weight = correlationWeight(luma.variance, luma.target_variance, luma.correlation);
    for (int c = 0; c < 3; ++c)
    {
        const ChannelCorrelation like = channelCorrelation(c, now[c].gain);
        if (!(like.variance > MIN_VARIANCE) || !(like.target_variance > MIN_VARIANCE))
            continue;
        const double decorrelation = std::max(1 - like.correlation * like.correlation, 0.0);
        const double wanted = plausibleGain(std::sqrt(like.target_variance / like.variance));
        const double stiffness = weight * support * decorrelation * color_[c][2] * like.variance;
        block.color_color[c][0] += stiffness;
        block.color_gradient[c][0] += stiffness * (now[c].gain - wanted);
        fixed.support[c] = correlation_weight * stiffness;
        fixed.wanted[c] = wanted;
        block.energy += fixed.support[c] * (now[c].gain - wanted) * (now[c].gain - wanted);
    }
    fixed.correlation_weight = correlation_weight;
    for (auto& row : block.mesh_color)
        for (double& value : row)
            value *= correlation_weight;
    for (int c = 0; c < 3; ++c)
    {
        for (double& value : block.color_color[c])
            value *= correlation_weight;
        for (double& value : block.color_gradient[c])
            value *= correlation_weight;
    }
}

GCPW_WIDE_VECTORS void CrossSums::add(const float* corner_weight, const double* target_weight, const LinearSample& s)
{
    const Curvature h = curvatureOf(s);
    double rx = 0;
    double ry = 0;
    for (int c = 0; c < 3; ++c)
    {
        rx += s.gx[c] * s.residual[c];
        ry += s.gy[c] * s.residual[c];
        const double i = s.mine[c];
        const double j = s.theirs[c];
        const double values[8] = {i * j, i, j, 1, j * j, j * s.residual[c], s.residual[c], i * i};
        for (int n = 0; n < 8; ++n)
            color_[c][n] += s.weight * values[n];
    }
    int pair = 0;
    for (int m = 0; m < 4; ++m)
    {
        const double wm = s.weight * target_weight[m];
        slope_[m][0] += wm * rx;
        slope_[m][1] += wm * ry;
        for (int k = 0; k < 4; ++k)
        {
            const double w = wm * corner_weight[k];
            cross_[k][m][0] += w * h.xx;
            cross_[k][m][1] += w * h.xy;
            cross_[k][m][2] += w * h.yy;
        }
        for (int n = m; n < 4; ++n, ++pair)
        {
            const double w = wm * target_weight[n];
            curvature_[pair][0] += w * h.xx;
            curvature_[pair][1] += w * h.xy;
            curvature_[pair][2] += w * h.yy;
        }
    }
}

CrossBlock CrossSums::block(double weight) const
{
    // d residual / d target position = +g, d residual / d target (gain, bias) = -(I', 1)
    CrossBlock block;
    unfold(curvature_, weight, block.mesh_mesh);
    for (int k = 0; k < 4; ++k)
    {
        for (int m = 0; m < 4; ++m)
        {
            const double* s = cross_[k][m];
            block.cross[2 * k][2 * m] = -weight * s[0];
            block.cross[2 * k][2 * m + 1] = -weight * s[1];
            block.cross[2 * k + 1][2 * m] = -weight * s[1];
            block.cross[2 * k + 1][2 * m + 1] = -weight * s[2];
        }
        for (int axis = 0; axis < 2; ++axis)
            block.mesh_gradient[2 * k + axis] = weight * slope_[k][axis];
    }
    for (int c = 0; c < 3; ++c)
    {
        for (int j = 0; j < 4; ++j)
            block.color_cross[c][j] = -weight * color_[c][j];
        block.color_color[c] = {{weight * color_[c][4], weight * color_[c][2], weight * color_[c][3]}};
        for (int j = 0; j < 2; ++j)
            block.color_gradient[c][j] = -weight * color_[c][5 + j];
    }
    return block;
}

std::array<double, 3> CrossSums::reweightColors(const ColorGrid::Quad& now, const ColorGrid::Quad& now_other, double weight,
                                               double correlation_weight, PhotometricBlock& own, CrossBlock& other) const
{
    std::array<double, 3> lacking{};
    for (int c = 0; c < 3; ++c)
    {
        const double* s = color_[c];
        const double variance = std::max(s[7] - s[1] * s[1] / s[3], 0.0);
        const double other_variance = std::max(s[4] - s[2] * s[2] / s[3], 0.0);
        const double missing = weight * (s[1] * s[2] / s[3] + std::sqrt(variance * other_variance) - s[0]);
        other.color_cross[c][0] -= missing;
        other.color_gradient[c][0] -= missing * now[c].gain;
        // The source's part of these samples has its correlation weight already.
        own.color_gradient[c][0] -= correlation_weight * missing * now_other[c].gain;
        lacking[c] = correlation_weight * missing;
        own.energy -= 2 * lacking[c] * now[c].gain * now_other[c].gain;
        for (double& value : other.color_cross[c])
            value *= correlation_weight;
        for (double& value : other.color_color[c])
            value *= correlation_weight;
        for (double& value : other.color_gradient[c])
            value *= correlation_weight;
    }
    return lacking;
}

} // namespace gcpw
} // namespace cv
