// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#include "color/color_agreement.hpp"

#include <algorithm>
#include <cmath>
#include "solver/robust_loss.hpp"

namespace cv
{
namespace gcpw
{

namespace
{

const double GRAY = 128.0 / 255;          ///< Cr and Cb of a pixel of equal channels
const double GRAY_DEVIATION = 0.5 / 255;  ///< root mean square; a photograph of a gray wall has ten times that
const double NORMAL = 1.4826;             ///< standard deviation over the median of the absolute value
const double LEAST_DEVIATION = 2.0 / 255; ///< resampling and compression make as much
const double CLIPPED_ALIKE = 5.0 / 255; ///< what both show at the limit of their range, alike in both, is to stay alike

double differenceOf(const ColorMoments& m, const ColorGrid::Quad& source, const ColorGrid::Quad& target, int channels)
{
    if (!(m.samples() > 0))
        return 0;
    double squared = 0;
    for (int c = 0; c < channels; ++c)
    {
        const double d =
            source[c].gain * m.sourceMean(c) + source[c].bias - target[c].gain * m.targetMean(c) - target[c].bias;
        squared += d * d;
    }
    return std::sqrt(squared);
}

/// The value below which half of the weight lies.
double weightedMedian(std::vector<std::pair<double, double>> values)
{
    std::sort(values.begin(), values.end());
    double total = 0;
    for (const auto& value : values)
        total += value.second;
    double sum = 0;
    for (const auto& value : values)
        if ((sum += value.second) >= 0.5 * total)
            return value.first;
    return 0;
}

} // namespace

std::vector<bool> grayImages(const std::vector<ColorComparison>& comparisons, size_t count)
{
    std::vector<double> deviation(count, 0);
    std::vector<double> samples(count, 0);
    for (const ColorComparison& comparison : comparisons)
        for (const QuadColors& quads : comparison.quads)
        {
            const ColorMoments& m = quads.moments;
            if (!(m.samples() > 0))
                continue;
            for (int c = 1; c < CHANNELS; ++c)
            {
                deviation[comparison.source_image] +=
                    m.samples() * (m.sourceVariance(c) + std::pow(m.sourceMean(c) - GRAY, 2));
                deviation[comparison.target_image] +=
                    m.samples() * (m.targetVariance(c) + std::pow(m.targetMean(c) - GRAY, 2));
            }
            samples[comparison.source_image] += m.samples();
            samples[comparison.target_image] += m.samples();
        }
    std::vector<bool> gray(count);
    for (size_t i = 0; i < count; ++i)
        gray[i] = samples[i] > 0 && deviation[i] < GRAY_DEVIATION * GRAY_DEVIATION * samples[i];
    return gray;
}

QuadWeights likenessOf(const std::vector<ColorComparison>& comparisons)
{
    QuadWeights weights;
    for (const ColorComparison& comparison : comparisons)
    {
        weights.emplace_back();
        for (const QuadColors& quads : comparison.quads)
            weights.back().push_back({likeness(quads.moments), 1});
    }
    return weights;
}

QuadWeights agreementOf(const std::vector<ColorComparison>& comparisons, const QuadWeights& likeness,
                        const std::vector<bool>& gray, const ColorOf& colors, double deviations)
{
    QuadWeights weights = likeness;
    for (size_t k = 0; k < comparisons.size(); ++k)
    {
        const ColorComparison& comparison = comparisons[k];
        std::vector<std::pair<double, double>> differences; // and their weights
        for (size_t q = 0; q < comparison.quads.size(); ++q)
        {
            const QuadColors& quads = comparison.quads[q];
            const double difference =
                differenceOf(quads.moments, colors(comparison.source_image, quads.source_cell),
                             colors(comparison.target_image, quads.target_cell), comparableChannels(comparison, gray));
            differences.emplace_back(difference, likeness[k][q].moments * quads.moments.samples());
        }
        const RobustLoss loss(deviations * std::max(NORMAL * weightedMedian(differences), LEAST_DEVIATION));
        for (size_t q = 0; q < differences.size(); ++q)
        {
            weights[k][q].moments *= loss.weight(differences[q].first * differences[q].first);
            const QuadColors& quads = comparison.quads[q];
            const double clipped =
                differenceOf(quads.clipped, colors(comparison.source_image, quads.source_cell),
                             colors(comparison.target_image, quads.target_cell), comparableChannels(comparison, gray));
            const double before =
                differenceOf(quads.clipped, ColorGrid::Quad(), ColorGrid::Quad(), comparableChannels(comparison, gray));
            weights[k][q].clipped =
                std::max(loss.weight(clipped * clipped), RobustLoss(CLIPPED_ALIKE).weight(before * before));
        }
    }
    return weights;
}

} // namespace gcpw
} // namespace cv
