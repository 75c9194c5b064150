// Part of the GCPW module for OpenCV. Licence: Apache-2.0 (see LICENSE).
#include "pipeline/color_rest.hpp"

#include <algorithm>
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
const double MAX_GAIN = 3;          ///< between two photographs of one scene

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

std::vector<ColorGrid::Quad> estimateExposures(const std::vector<PhotometricTerm>& terms,
                                               const std::vector<ImageState>& states, const std::vector<bool>& held)
{
    std::vector<PhotometricTerm::Moments> moments;
    for (const PhotometricTerm& term : terms)
        moments.push_back(term.moments(states));
    std::vector<ColorGrid::Quad> exposures(states.size());
    for (int c = 0; c < CHANNELS; ++c)
    {
        Differences log_gains(held);
        for (size_t k = 0; k < terms.size(); ++k)
        {
            const PhotometricTerm::Moments& m = moments[k];
            if (m.samples > 0)
                log_gains.add(terms[k].sourceImage(), terms[k].targetImage(),
                              0.5 * std::log((m.target_variance[c] + NOISE_VARIANCE) / (m.source_variance[c] + NOISE_VARIANCE)),
                              m.samples);
        }
        const std::vector<double> logs = log_gains.solve();
        for (size_t i = 0; i < exposures.size(); ++i)
            exposures[i][c].gain = std::min(std::max(std::exp(logs[i]), 1 / MAX_GAIN), MAX_GAIN);
        Differences biases(held);
        for (size_t k = 0; k < terms.size(); ++k)
        {
            const int a = terms[k].sourceImage();
            const int b = terms[k].targetImage();
            const PhotometricTerm::Moments& m = moments[k];
            if (m.samples > 0)
                biases.add(a, b, exposures[b][c].gain * m.target_mean[c] - exposures[a][c].gain * m.source_mean[c], m.samples);
        }
        const std::vector<double> found = biases.solve();
        for (size_t i = 0; i < exposures.size(); ++i)
            exposures[i][c].bias = found[i];
    }
    return exposures;
}

void ColorRest::pull(const std::vector<PhotometricTerm>& terms, const std::vector<ImageState>& states, ColorSystem& colors)
{
    if (exposures_.empty())
    {
        std::vector<bool> held;
        for (const ProblemImage& image : problem_.images)
            held.push_back(image.held);
        exposures_.resize(states.size());
        if (problem_.isChain() || exposure_weight_ > 0)
            exposures_ = estimateExposures(terms, states, held);
    }
    std::vector<std::vector<int>> inside;
    for (const ImageState& state : states)
        inside.emplace_back(state.mesh.lattice().cellCount(), 0);
    for (const PhotometricTerm& term : terms)
        term.countInside(states, inside[term.sourceImage()], inside[term.targetImage()]);
    // In a pair colours fade to the photograph's own outside the overlap, as in the paper.
    const std::vector<ColorGrid::Quad> outside = problem_.isChain() ? exposures_ : std::vector<ColorGrid::Quad>(states.size());
    colors.clearPulls();
    for (size_t i = 0; i < states.size(); ++i)
        for (size_t cell = 0; cell < inside[i].size(); ++cell)
        {
            const bool overlaps = inside[i][cell] > 0;
            const double weight = overlaps ? exposure_weight_ : rest_weight_;
            if (weight > 0)
                colors.addPull({static_cast<int>(i), static_cast<int>(cell)}, weight, overlaps ? exposures_[i] : outside[i]);
        }
}

} // namespace gcpw
} // namespace cv
