// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#include "imaging/score.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>
#include <opencv2/core/utility.hpp>
#include <opencv2/imgproc.hpp>
// boundingRect(), part of imgproc before OpenCV 5.
#if CV_VERSION_MAJOR >= 5
#include <opencv2/geometry.hpp>
#endif

namespace cv
{
namespace gcpw
{

namespace
{

const int WINDOW = 5;             ///< px, the paper's W
const int BORDER = 7;             ///< px, side of the square that erodes the overlap
const double MIN_VARIANCE = 16.0; ///< gray levels squared; the correlation of flatter windows is noise

const int BAND = 64; ///< rows scored at once: their sums stay in the cache; sets the order of the sums

/// Sums over the overlap, of windows whose sums are whole numbers and so exact.
struct Sums
{
    double ncc = 0;
    double zncc = 0;
    size_t windows = 0;
    size_t textured = 0;

    void add(const int (&sum)[5])
    {
        const double n = WINDOW * WINDOW;
        const double mp = sum[0] / n;
        const double mq = sum[1] / n;
        const double p = sum[2] / n;
        const double q = sum[3] / n;
        const double r = sum[4] / n;
        const double e = 1 - r / std::sqrt(std::max(p * q, 1e-9));
        ncc += e * e;
        ++windows;
        const double va = p - mp * mp;
        const double vb = q - mq * mq;
        if (va <= MIN_VARIANCE || vb <= MIN_VARIANCE)
            return;
        const double z = 1 - std::min(std::max((r - mp * mq) / (std::sqrt(va) * std::sqrt(vb)), -1.0), 1.0);
        zncc += z * z;
        ++textured;
    }
};

/// Values, squares and product of two rows, added to sums over the rows of a window or taken off them.
void addRow(const uchar* a, const uchar* b, int sign, std::vector<int> (&columns)[5])
{
    const int width = static_cast<int>(columns[0].size());
    for (int x = 0; x < width; ++x)
    {
        const int p = a[x];
        const int q = b[x];
        columns[0][x] += sign * p;
        columns[1][x] += sign * q;
        columns[2][x] += sign * p * p;
        columns[3][x] += sign * q * q;
        columns[4][x] += sign * p * q;
    }
}

/// The windows around some rows; `inside` leaves out those that would leave the images.
Sums scoreRows(const Mat& a, const Mat& b, const Mat& inside, Range rows)
{
    const int half = WINDOW / 2;
    Sums sums;
    std::vector<int> columns[5];
    for (std::vector<int>& column : columns)
        column.assign(a.cols, 0);
    const Range whole(std::max(rows.start, half), std::min(rows.end, a.rows - half));
    for (int y = whole.start - half; y < whole.start + half && y < a.rows; ++y)
        addRow(a.ptr(y), b.ptr(y), 1, columns);
    for (int y = whole.start; y < whole.end; ++y)
    {
        addRow(a.ptr(y + half), b.ptr(y + half), 1, columns);
        const uchar* valid = inside.ptr(y);
        for (int x = half; x < a.cols - half; ++x)
        {
            if (!valid[x])
                continue;
            int sum[5];
            for (int k = 0; k < 5; ++k)
            {
                static_assert(WINDOW == 5, "five columns are added");
                const int* s = columns[k].data() + x - half;
                sum[k] = s[0] + s[1] + s[2] + s[3] + s[4];
            }
            sums.add(sum);
        }
        addRow(a.ptr(y - half), b.ptr(y - half), -1, columns);
    }
    return sums;
}

double rms(double sum, size_t count)
{
    return count ? 100 * std::sqrt(sum / static_cast<double>(count)) : std::numeric_limits<double>::quiet_NaN();
}

} // namespace

Score scoreOverlap(const Mat& a, const Mat& b, const Mat& mask)
{
    CV_Assert(a.size() == b.size() && a.size() == mask.size() && mask.type() == CV_8UC1);
    const Rect overlap = boundingRect(mask); // all else is left out
    Mat gray[2];
    Mat inside;
    if (!overlap.empty())
    {
        cvtColor(a(overlap), gray[0], COLOR_BGR2GRAY);
        cvtColor(b(overlap), gray[1], COLOR_BGR2GRAY);
        const Mat shown = mask(overlap).clone(); // filters would read beyond the overlap
        erode(shown, inside, Mat::ones(BORDER, BORDER, CV_8U), Point(-1, -1), 1, BORDER_CONSTANT, Scalar(0));
    }
    std::vector<Sums> bands((inside.rows + BAND - 1) / BAND);
    parallel_for_(Range(0, static_cast<int>(bands.size())),
                  [&](const Range& range)
                  {
        for (int k = range.start; k < range.end; ++k)
            bands[k] = scoreRows(gray[0], gray[1], inside, Range(k * BAND, std::min((k + 1) * BAND, inside.rows)));
    });
    double ncc = 0;
    double zncc = 0;
    size_t windows = 0;
    size_t textured = 0;
    for (const Sums& band : bands)
    {
        ncc += band.ncc;
        zncc += band.zncc;
        windows += band.windows;
        textured += band.textured;
    }
    Score score;
    score.ncc = rms(ncc, windows);
    score.zncc = rms(zncc, textured);
    return score;
}

} // namespace gcpw
} // namespace cv
