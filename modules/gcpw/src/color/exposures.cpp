// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#include "color/exposures.hpp"

#include <cmath>
#include <opencv2/core/utils/logger.hpp>
#include "color/color_agreement.hpp"
#include "overlap/tone.hpp"

namespace cv
{
namespace gcpw
{

namespace
{

const double GAUGE = 1e-3;          ///< share of an overlap: chooses among exposures that fit equally well
const double NOISE_VARIANCE = 1e-4; ///< of an intensity: the ratio of less contrast is noise
/// Of Cr and Cb: with less contrast they scale as Y does, as with a longer exposure. A gain of their own tints what is strongly coloured.
const double COLORFUL_VARIANCE = 5e-3;
const double LEAST_LIGHT = 0.02; ///< of an intensity, added to means whose ratio is taken: that of two blacks is noise
const double LIGHT_SHARE = 0.3;  ///< of the logarithm of a gain; cv::detail::GainCompensator leaves about as much
const double HUE_SHARE = 0.2;    ///< of a shift of Cr and Cb
const double DEVIATIONS = 2.5;   ///< robust standard deviations beyond which a quad does not show the exposures
const int ROUNDS = 10;           ///< of re-weighting

/// Normal equations of differences x_a - x_b = d between images; x is exactly 0 where an image is fixed.
class Differences
{
public:
    explicit Differences(const std::vector<bool>& fixed)
        : fixed_(fixed), matrix_(Mat::zeros(static_cast<int>(fixed.size()), static_cast<int>(fixed.size()), CV_64F)),
          right_(Mat::zeros(static_cast<int>(fixed.size()), 1, CV_64F))
    {
    }

    /// weight * (x_a - x_b - d)^2
    void add(int a, int b, double d, double weight)
    {
        matrix_.at<double>(a, a) += weight;
        matrix_.at<double>(b, b) += weight;
        matrix_.at<double>(a, b) -= weight;
        matrix_.at<double>(b, a) -= weight;
        right_.at<double>(a) += weight * d;
        right_.at<double>(b) -= weight * d;
        total_ += weight;
    }

    /// False if the equations are singular; `x` is then all 0.
    [[nodiscard]] bool solve(std::vector<double>& x) const
    {
        x.assign(fixed_.size(), 0);
        std::vector<int> free;
        for (int i = 0; i < matrix_.rows; ++i)
            if (!fixed_[i])
                free.push_back(i);
        if (free.empty())
            return true;
        const int count = static_cast<int>(free.size());
        Mat matrix(count, count, CV_64F);
        Mat right(count, 1, CV_64F);
        for (int i = 0; i < count; ++i)
        {
            right.at<double>(i) = right_.at<double>(free[i]);
            for (int j = 0; j < count; ++j)
                matrix.at<double>(i, j) =
                    matrix_.at<double>(free[i], free[j]) + (i == j ? GAUGE * total_ / matrix_.rows : 0);
        }
        Mat found;
        if (!cv::solve(matrix, right, found, DECOMP_CHOLESKY) || !checkRange(found))
            return false;
        for (int i = 0; i < count; ++i)
            x[free[i]] = found.at<double>(i);
        return true;
    }

private:
    const std::vector<bool>& fixed_;
    Mat matrix_;
    Mat right_;
    double total_ = 1e-9;
};

/// Logarithm of the gain that gives the source the contrast of the target in a channel.
double logRatio(const ColorMoments& m, int channel, bool by_luma)
{
    if (channel == 0 || !by_luma)
        return 0.5 *
               std::log((m.targetVariance(channel) + NOISE_VARIANCE) / (m.sourceVariance(channel) + NOISE_VARIANCE));
    const double luma = (m.targetVariance(0) + NOISE_VARIANCE) / (m.sourceVariance(0) + NOISE_VARIANCE);
    // Symmetric: the two images may change places.
    const double even = std::sqrt(luma);
    return 0.5 * std::log((m.targetVariance(channel) + COLORFUL_VARIANCE * even) /
                          (m.sourceVariance(channel) + COLORFUL_VARIANCE / even));
}

/// One sum of each comparison.
typedef std::vector<ColorMoments> MomentsOfPairs;

MomentsOfPairs weighted(const std::vector<ColorComparison>& comparisons, const QuadWeights& weights)
{
    MomentsOfPairs moments(comparisons.size());
    for (size_t k = 0; k < comparisons.size(); ++k)
        for (size_t q = 0; q < comparisons[k].quads.size(); ++q)
            moments[k].add(comparisons[k].quads[q].moments, weights[k][q].moments);
    return moments;
}

/// The exposures that fit these sums.
std::vector<ColorGrid::Quad> fit(const std::vector<ColorComparison>& comparisons, const MomentsOfPairs& moments,
                                 const std::vector<bool>& gray, const std::vector<bool>& fixed, bool by_luma)
{
    std::vector<ColorGrid::Quad> exposures(fixed.size());
    for (int c = 0; c < CHANNELS; ++c)
    {
        Differences log_gains(fixed);
        for (size_t k = 0; k < comparisons.size(); ++k)
        {
            const ColorMoments& m = moments[k];
            if (m.samples() > 0 && c < comparableChannels(comparisons[k], gray))
                log_gains.add(comparisons[k].source_image, comparisons[k].target_image, logRatio(m, c, by_luma),
                              m.samples());
        }
        std::vector<double> found;
        if (!log_gains.solve(found))
        {
            CV_LOG_INFO(nullptr,
                        "gcpw: the images' gains are not determined in channel " << c << "; they are taken as 1");
            continue;
        }
        for (size_t i = 0; i < exposures.size(); ++i)
            exposures[i][c].gain = fixed[i] ? 1 : plausibleGain(std::exp(found[i]));
        Differences biases(fixed);
        for (size_t k = 0; k < comparisons.size(); ++k)
        {
            const int a = comparisons[k].source_image;
            const int b = comparisons[k].target_image;
            const ColorMoments& m = moments[k];
            if (m.samples() > 0 && c < comparableChannels(comparisons[k], gray))
                biases.add(a, b, exposures[b][c].gain * m.targetMean(c) - exposures[a][c].gain * m.sourceMean(c),
                           m.samples());
        }
        if (!biases.solve(found))
            CV_LOG_INFO(nullptr,
                        "gcpw: the images' biases are not determined in channel " << c << "; they are taken as 0");
        for (size_t i = 0; i < exposures.size(); ++i)
            exposures[i][c].bias = found[i];
    }
    return exposures;
}

/// The exposures that fit the quads which show them, and the moments of those.
std::vector<ColorGrid::Quad> robustExposures(const std::vector<ColorComparison>& comparisons,
                                             const std::vector<bool>& fixed, MomentsOfPairs& moments)
{
    const std::vector<bool> gray = grayImages(comparisons, fixed.size());
    const QuadWeights likeness = likenessOf(comparisons);
    moments = weighted(comparisons, likeness);
    std::vector<ColorGrid::Quad> exposures = fit(comparisons, moments, gray, fixed, true);
    for (int round = 0; round < ROUNDS; ++round)
    {
        const ColorOf colors = [&](int image, int) -> const ColorGrid::Quad& { return exposures[image]; };
        moments = weighted(comparisons, agreementOf(comparisons, likeness, gray, colors, DEVIATIONS));
        exposures = fit(comparisons, moments, gray, fixed, true);
    }
    return exposures;
}

} // namespace

std::vector<ColorGrid::Quad> estimateExposures(const std::vector<ColorComparison>& comparisons,
                                               const std::vector<bool>& fixed)
{
    MomentsOfPairs moments;
    return robustExposures(comparisons, fixed, moments);
}

std::vector<ColorGrid::Quad> sharedLights(const std::vector<ColorComparison>& comparisons, size_t count)
{
    const std::vector<bool> fixed(count, false);
    const std::vector<bool> gray = grayImages(comparisons, count);
    MomentsOfPairs moments;
    robustExposures(comparisons, fixed, moments);
    std::vector<ColorGrid::Quad> lights(count);
    std::vector<double> found;
    for (int c = 0; c < CHANNELS; ++c)
    {
        const auto comparable = [&](size_t k)
        { return moments[k].samples() > 0 && c < comparableChannels(comparisons[k], gray); };
        Differences log_gains(fixed);
        for (size_t k = 0; k < comparisons.size(); ++k)
            if (comparable(k))
                log_gains.add(
                    comparisons[k].source_image, comparisons[k].target_image,
                    std::log((moments[k].targetMean(0) + LEAST_LIGHT) / (moments[k].sourceMean(0) + LEAST_LIGHT)),
                    moments[k].samples());
        if (!log_gains.solve(found))
            continue;
        std::vector<double> gains;
        for (const double log_gain : found)
            gains.push_back(plausibleGain(std::exp(log_gain)));
        Differences shifts(fixed);
        for (size_t k = 0; c > 0 && k < comparisons.size(); ++k)
        {
            const int a = comparisons[k].source_image;
            const int b = comparisons[k].target_image;
            if (comparable(k))
                shifts.add(a, b,
                           gains[b] * (moments[k].targetMean(c) - NEUTRAL) -
                               gains[a] * (moments[k].sourceMean(c) - NEUTRAL),
                           moments[k].samples());
        }
        if (!shifts.solve(found))
            continue;
        for (size_t i = 0; i < count; ++i)
        {
            lights[i][c].gain = std::pow(gains[i], LIGHT_SHARE);
            lights[i][c].bias = c == 0 ? 0 : HUE_SHARE * found[i] + NEUTRAL * (1 - lights[i][c].gain);
        }
    }
    return lights;
}

std::vector<ColorGrid::Quad> exposuresOfAllPixels(const std::vector<ColorComparison>& comparisons,
                                                  const std::vector<bool>& fixed)
{
    MomentsOfPairs moments(comparisons.size());
    for (size_t k = 0; k < comparisons.size(); ++k)
        for (const QuadColors& quads : comparisons[k].quads)
        {
            ColorMoments all = quads.moments;
            all.add(quads.clipped, 1);
            moments[k].add(all, correlationWeight(all));
        }
    return fit(comparisons, moments, std::vector<bool>(fixed.size(), false), fixed, false);
}

} // namespace gcpw
} // namespace cv
