// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#include "evaluation/locality_sensitive_histogram.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <opencv2/imgproc.hpp>
#include <vector>

namespace evaluation
{

namespace
{

const int LANES = 8; ///< bins filtered at a time: bounds the memory

typedef cv::Vec<float, LANES> Lanes;
typedef cv::Mat_<Lanes> LaneImage;

/// sum_q alpha^|p-q| v_q along a line of `count` values `step` apart, in place: one pass each way, added.
void spreadLine(Lanes* values, int count, size_t step, float alpha, std::vector<Lanes>& backward)
{
    backward.resize(static_cast<size_t>(count));
    Lanes sum = Lanes::all(0);
    for (int i = count - 1; i >= 0; --i)
    {
        backward[i] = sum; // what lies behind, the value itself left out
        sum = alpha * (sum + values[i * step]);
    }
    sum = Lanes::all(0);
    for (int i = 0; i < count; ++i)
    {
        Lanes& value = values[i * step];
        sum = value + alpha * sum;
        value = sum + backward[i];
    }
}

/// The same down the columns, a whole row at a time.
void spreadColumns(LaneImage& image, float alpha)
{
    LaneImage below(image.size());
    below.row(image.rows - 1).setTo(0);
    for (int y = image.rows - 2; y >= 0; --y)
        for (int x = 0; x < image.cols; ++x)
            below(y, x) = alpha * (below(y + 1, x) + image(y + 1, x));
    for (int y = 1; y < image.rows; ++y)
        for (int x = 0; x < image.cols; ++x)
            image(y, x) += alpha * image(y - 1, x);
    for (int y = 0; y < image.rows; ++y)
        for (int x = 0; x < image.cols; ++x)
            image(y, x) += below(y, x);
}

/// sum_q alpha^|p-q| along a line of this length, for every p.
std::vector<float> weightSums(int count, float alpha)
{
    std::vector<Lanes> ones(static_cast<size_t>(count), Lanes::all(1));
    std::vector<Lanes> scratch;
    spreadLine(ones.data(), count, 1, alpha, scratch);
    std::vector<float> sums;
    for (const Lanes& value : ones)
        sums.push_back(value[0]);
    return sums;
}

} // namespace

cv::Mat invariantImage(const cv::Mat& image, const LshOptions& options)
{
    if (image.empty() || (image.type() != CV_8UC3 && image.type() != CV_8UC1))
        CV_Error(cv::Error::StsUnsupportedFormat, "an invariant image is made of 8-bit BGR or gray");
    CV_Check(options.bins, options.bins >= 2 && options.bins <= 256, "LshOptions::bins lies in 2..256");
    CV_CheckGT(options.reach, 0.0, "LshOptions::reach is above 0");
    CV_CheckGT(options.relative, 0.0, "LshOptions::relative is above 0");
    CV_CheckGT(options.narrowest, 0.0, "LshOptions::narrowest is above 0");
    cv::Mat gray;
    if (image.channels() == 3)
        cv::cvtColor(image, gray, cv::COLOR_BGR2GRAY);
    else
        gray = image;
    const float alpha = static_cast<float>(std::exp(-1 / (options.reach * std::hypot(image.cols, image.rows))));
    const std::vector<float> row_sums = weightSums(gray.cols, alpha);
    const std::vector<float> column_sums = weightSums(gray.rows, alpha);

    // Of each intensity: its place among the bins, and how much each bin counts for it.
    std::array<float, 256> place{};
    cv::Mat_<float> kernel(256, options.bins);
    for (int i = 0; i < 256; ++i)
    {
        place[i] = static_cast<float>(i) * static_cast<float>(options.bins - 1) / 255.0F;
        const double width = std::max(options.narrowest, options.relative * place[i]);
        for (int b = 0; b < options.bins; ++b)
            kernel(i, b) = static_cast<float>(std::exp(-(b - place[i]) * (b - place[i]) / (2 * width * width)));
    }

    cv::Mat_<float> value = cv::Mat_<float>::zeros(gray.size());
    LaneImage counts(gray.size());
    std::vector<Lanes> scratch;
    for (int first = 0; first < options.bins; first += LANES)
    {
        for (int y = 0; y < gray.rows; ++y)
        {
            for (int x = 0; x < gray.cols; ++x)
                for (int k = 0; k < LANES; ++k)
                    counts(y, x)[k] = std::max(0.0F, 1 - std::abs(place[gray.at<uchar>(y, x)] - static_cast<float>(first + k)));
            spreadLine(counts[y], gray.cols, 1, alpha, scratch);
        }
        spreadColumns(counts, alpha);
        for (int y = 0; y < gray.rows; ++y)
            for (int x = 0; x < gray.cols; ++x)
            {
                const float* weights = kernel[gray.at<uchar>(y, x)];
                for (int k = 0; k < std::min(LANES, options.bins - first); ++k)
                    value(y, x) += weights[first + k] * counts(y, x)[k];
            }
    }
    cv::Mat bytes(gray.size(), CV_8UC1);
    for (int y = 0; y < gray.rows; ++y)
        for (int x = 0; x < gray.cols; ++x)
            bytes.at<uchar>(y, x) = cv::saturate_cast<uchar>(255 * value(y, x) / (column_sums[y] * row_sums[x]));
    cv::Mat result;
    cv::cvtColor(bytes, result, cv::COLOR_GRAY2BGR);
    return result;
}

} // namespace evaluation
