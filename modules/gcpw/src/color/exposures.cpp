// Part of the GCPW module for OpenCV. Licence: Apache-2.0 (see LICENSE).
#include "color/exposures.hpp"

#include <cmath>

namespace cv
{
namespace gcpw
{

namespace
{

const double GAUGE = 1e-3;          ///< share of an overlap: chooses among exposures that fit equally well
const double HOLD = 1e6;            ///< overlaps: as good as fixed
const double NOISE_VARIANCE = 1e-4; ///< of an intensity: less contrast than this says nothing of gain

/// Normal equations of differences x_a - x_b = d between images; x is 0 where an image is held.
class Differences
{
public:
    explicit Differences(const std::vector<bool>& held)
        : held_(held), matrix_(Mat::zeros(static_cast<int>(held.size()), static_cast<int>(held.size()), CV_64F)),
          right_(Mat::zeros(static_cast<int>(held.size()), 1, CV_64F))
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

    std::vector<double> solve() const
    {
        Mat matrix = matrix_.clone();
        for (int i = 0; i < matrix.rows; ++i)
            matrix.at<double>(i, i) += GAUGE * total_ / matrix.rows + (held_[i] ? HOLD * total_ : 0);
        Mat x;
        if (!cv::solve(matrix, right_, x, DECOMP_CHOLESKY))
            return std::vector<double>(held_.size(), 0);
        return std::vector<double>(x.begin<double>(), x.end<double>());
    }

private:
    const std::vector<bool>& held_;
    Mat matrix_;
    Mat right_;
    double total_ = 1e-9;
};

} // namespace

std::vector<ColorGrid::Quad> estimateExposures(const std::vector<ColorComparison>& comparisons,
                                               const std::vector<bool>& held)
{
    std::vector<ColorMoments> moments(comparisons.size());
    for (size_t k = 0; k < comparisons.size(); ++k)
        for (const PhotometricTerm::QuadColors& quads : comparisons[k].quads)
            moments[k].add(quads.moments, trustIn(quads.moments));
    std::vector<ColorGrid::Quad> exposures(held.size());
    for (int c = 0; c < CHANNELS; ++c)
    {
        Differences log_gains(held);
        for (size_t k = 0; k < comparisons.size(); ++k)
        {
            const ColorMoments& m = moments[k];
            if (m.samples() > 0)
                log_gains.add(comparisons[k].source_image, comparisons[k].target_image,
                              0.5 * std::log((m.targetVariance(c) + NOISE_VARIANCE) / (m.sourceVariance(c) + NOISE_VARIANCE)),
                              m.samples());
        }
        const std::vector<double> logs = log_gains.solve();
        for (size_t i = 0; i < exposures.size(); ++i)
            exposures[i][c].gain = plausibleGain(std::exp(logs[i]));
        Differences biases(held);
        for (size_t k = 0; k < comparisons.size(); ++k)
        {
            const int a = comparisons[k].source_image;
            const int b = comparisons[k].target_image;
            const ColorMoments& m = moments[k];
            if (m.samples() > 0)
                biases.add(a, b, exposures[b][c].gain * m.targetMean(c) - exposures[a][c].gain * m.sourceMean(c), m.samples());
        }
        const std::vector<double> found = biases.solve();
        for (size_t i = 0; i < exposures.size(); ++i)
            exposures[i][c].bias = found[i];
    }
    return exposures;
}

} // namespace gcpw
} // namespace cv
