// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#include "imaging/score.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <opencv2/imgproc.hpp>

namespace cv
{
namespace gcpw
{

namespace
{

const int WINDOW = 5;             ///< px, the paper's W
const int BORDER = 7;             ///< px, side of the square that erodes the overlap
const double MIN_VARIANCE = 16.0; ///< gray levels squared; the correlation of flatter windows is noise

Mat windowMean(const Mat& image)
{
    Mat mean;
    blur(image, mean, Size(WINDOW, WINDOW));
    return mean;
}

double rms(double sum, size_t count)
{
    return count ? 100 * std::sqrt(sum / static_cast<double>(count)) : std::numeric_limits<double>::quiet_NaN();
}

} // namespace

Score scoreOverlap(const Mat& a, const Mat& b, const Mat& mask)
{
    CV_Assert(a.size() == b.size() && a.size() == mask.size() && mask.type() == CV_8UC1);
    Mat gray[2];
    cvtColor(a, gray[0], COLOR_BGR2GRAY);
    cvtColor(b, gray[1], COLOR_BGR2GRAY);
    for (Mat& g : gray)
        g.convertTo(g, CV_64F);
    const Mat ma = windowMean(gray[0]);
    const Mat mb = windowMean(gray[1]);
    const Mat aa = windowMean(gray[0].mul(gray[0]));
    const Mat bb = windowMean(gray[1].mul(gray[1]));
    const Mat ab = windowMean(gray[0].mul(gray[1]));
    Mat inside;
    erode(mask, inside, Mat::ones(BORDER, BORDER, CV_8U), Point(-1, -1), 1, BORDER_CONSTANT, Scalar(0));
    double ncc = 0;
    double zncc = 0;
    size_t windows = 0;
    size_t textured = 0;
    for (int y = 0; y < inside.rows; ++y)
        for (int x = 0; x < inside.cols; ++x)
        {
            if (!inside.at<uchar>(y, x))
                continue;
            const double p = aa.at<double>(y, x);
            const double q = bb.at<double>(y, x);
            const double r = ab.at<double>(y, x);
            const double mp = ma.at<double>(y, x);
            const double mq = mb.at<double>(y, x);
            const double e = 1 - r / std::sqrt(std::max(p * q, 1e-9));
            ncc += e * e;
            ++windows;
            const double va = p - mp * mp;
            const double vb = q - mq * mq;
            if (va <= MIN_VARIANCE || vb <= MIN_VARIANCE)
                continue;
            const double z = 1 - std::min(std::max((r - mp * mq) / (std::sqrt(va) * std::sqrt(vb)), -1.0), 1.0);
            zncc += z * z;
            ++textured;
        }
    Score score;
    score.ncc = rms(ncc, windows);
    score.zncc = rms(zncc, textured);
    return score;
}

} // namespace gcpw
} // namespace cv
