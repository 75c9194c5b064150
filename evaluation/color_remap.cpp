// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#include "evaluation/color_remap.hpp"

#include <vector>

namespace evaluation
{

namespace
{

const int QUANTILES = 99; ///< 1 % to 99 %: beyond lie specular and clipped pixels

/// Quantiles of one channel over a mask, in [0, 1]; within a gray level as if its pixels were spread over it evenly.
std::vector<double> quantilesOf(const cv::Mat& image, int channel, const cv::Mat& mask)
{
    std::array<double, 256> histogram{};
    double total = 0;
    for (int y = 0; y < image.rows; ++y)
        for (int x = 0; x < image.cols; ++x)
            if (mask.at<uchar>(y, x))
            {
                ++histogram[image.at<cv::Vec3b>(y, x)[channel]];
                ++total;
            }
    std::vector<double> quantiles;
    if (total == 0)
        return quantiles;
    int level = 0;
    double below = 0;
    for (int q = 1; q <= QUANTILES; ++q)
    {
        const double wanted = total * q / (QUANTILES + 1);
        while (below + histogram[level] < wanted)
            below += histogram[level++];
        quantiles.push_back((level - 0.5 + (wanted - below) / histogram[level]) / 255);
    }
    return quantiles;
}

} // namespace

ColorCurves fitColorCurves(const cv::Mat& from, const cv::Mat& from_mask, const cv::Mat& to, const cv::Mat& to_mask,
                           const SplineOptions& options)
{
    CV_CheckTypeEQ(from.type(), CV_8UC3, "colours are remapped in 8-bit BGR");
    CV_CheckTypeEQ(to.type(), CV_8UC3, "colours are remapped in 8-bit BGR");
    CV_Assert(from_mask.type() == CV_8UC1 && from_mask.size() == from.size());
    CV_Assert(to_mask.type() == CV_8UC1 && to_mask.size() == to.size());
    ColorCurves curves;
    for (int channel = 0; channel < 3; ++channel)
    {
        const std::vector<double> x = quantilesOf(from, channel, from_mask);
        const std::vector<double> y = quantilesOf(to, channel, to_mask);
        if (!x.empty() && !y.empty())
            curves[channel] = MonotoneSpline::fit(x, y, options);
    }
    return curves;
}

cv::Mat applyColorCurves(const cv::Mat& image, const ColorCurves& curves)
{
    CV_CheckTypeEQ(image.type(), CV_8UC3, "colours are remapped in 8-bit BGR");
    cv::Mat table(1, 256, CV_8UC3);
    for (int i = 0; i < 256; ++i)
        for (int channel = 0; channel < 3; ++channel)
            table.at<cv::Vec3b>(i)[channel] = cv::saturate_cast<uchar>(255 * curves[channel].at(i / 255.0));
    cv::Mat result;
    cv::LUT(image, table, result);
    return result;
}

ColorCurves overlapCurves(const cv::Mat& source, const cv::Mat& target, const cv::gcpw::PairMatches& matches,
                          const cv::gcpw::Params& params)
{
    cv::gcpw::Params by_matches = params;
    by_matches.method = cv::gcpw::Method::DFW;
    const cv::gcpw::Alignment alignment = cv::gcpw::alignPair(source, target, matches, by_matches);
    if (alignment.imageCount() == 0)
        return ColorCurves();
    const cv::gcpw::PairCanvas canvas = cv::gcpw::renderPair(alignment, source, target);
    const cv::Mat overlap = canvas.source_mask & canvas.target_mask;
    cv::Mat from = canvas.source;
    cv::Mat to = canvas.target;
    if (from.depth() == CV_16U) // both then
    {
        from.convertTo(from, CV_8U, 1.0 / 257);
        to.convertTo(to, CV_8U, 1.0 / 257);
    }
    return fitColorCurves(from, overlap, to, overlap);
}

} // namespace evaluation
