// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#include "cameras/link_check.hpp"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>

namespace cv
{
namespace gcpw
{

namespace
{

const double LOOK_SIDE_PX =
    320; ///< longer side of the pictures that are compared: parallax of a photograph is a few px there
const int WINDOW_PX = 16;
const double MIN_DEVIATION = 2.5; ///< gray levels: a flat window says nothing
const int MIN_WINDOWS = 6;
const double MIN_CORRELATION = 0.4; ///< false pairs stay below 0.2, true ones with parallax are above 0.5
const double MIN_SHARE = 0.03;
const double MAX_ZOOM = 3; ///< between photographs of one set
const int MIN_INLIERS = 8; ///< a homography fits any four; of fewer its overlap is a matter of chance
const double SURE = 1.01;  ///< times the confidence asked for: a confirmed link counts, and others count more

Mat small(const Mat& image, double scale)
{
    Mat gray = image;
    if (image.channels() > 1)
        cvtColor(image, gray, image.channels() == 4 ? COLOR_BGRA2GRAY : COLOR_BGR2GRAY);
    Mat result;
    resize(gray, result, Size(), scale, scale, INTER_AREA);
    GaussianBlur(result, result, Size(), 1);
    return result;
}

/// Correlation of two windows; false if one of them shows nothing.
bool correlate(const Mat& a, const Mat& b, double& correlation)
{
    Scalar mean_a;
    Scalar mean_b;
    Scalar deviation_a;
    Scalar deviation_b;
    meanStdDev(a, mean_a, deviation_a);
    meanStdDev(b, mean_b, deviation_b);
    if (deviation_a[0] < MIN_DEVIATION || deviation_b[0] < MIN_DEVIATION)
        return false;
    const double product = a.dot(b) / static_cast<double>(a.total()) - mean_a[0] * mean_b[0];
    correlation = product / (deviation_a[0] * deviation_b[0]);
    return true;
}

/// Whether a homography neither mirrors nor zooms much at a point. At the far end of a wide view it may do both.
bool isUpright(const Matx33d& h, Point2f p)
{
    const double w = h(2, 0) * p.x + h(2, 1) * p.y + h(2, 2);
    const double determinant_there = determinant(h) / (w * w * w);
    return determinant_there >= 1 / (MAX_ZOOM * MAX_ZOOM) && determinant_there <= MAX_ZOOM * MAX_ZOOM;
}

} // namespace

OverlapLook lookAtOverlap(const Mat& a, const Mat& b, const Matx33d& b_from_a)
{
    OverlapLook look;
    const double scale = std::min(1.0, LOOK_SIDE_PX / std::max(std::max(a.cols, a.rows), std::max(b.cols, b.rows)));
    const Matx33d down(scale, 0, 0, 0, scale, 0, 0, 0, 1);
    const Mat seen_b = small(b, scale);
    const Mat seen_a = small(a, scale);
    const Mat h(down * b_from_a * down.inv());
    Mat laid;
    Mat inside;
    warpPerspective(seen_a, laid, h, seen_b.size());
    warpPerspective(Mat(seen_a.size(), CV_8UC1, Scalar(255)), inside, h, seen_b.size(), INTER_NEAREST);
    const double smaller = static_cast<double>(std::min(seen_a.total(), seen_b.total()));
    look.share = countNonZero(inside) / std::max(1.0, smaller);
    laid.convertTo(laid, CV_32F);
    Mat target;
    seen_b.convertTo(target, CV_32F);
    double sum = 0;
    for (int y = 0; y + WINDOW_PX <= inside.rows; y += WINDOW_PX / 2)
        for (int x = 0; x + WINDOW_PX <= inside.cols; x += WINDOW_PX / 2)
        {
            const Rect window(x, y, WINDOW_PX, WINDOW_PX);
            double correlation = 0;
            if (countNonZero(inside(window)) < window.area() ||
                !correlate(laid(window).clone(), target(window).clone(), correlation))
                continue;
            sum += correlation;
            ++look.windows;
        }
    look.correlation = look.windows > 0 ? sum / look.windows : 0;
    return look;
}

bool showTheSame(const Mat& a, const Mat& b, const Matx33d& b_from_a, const std::vector<Point2f>& inliers)
{
    if (static_cast<int>(inliers.size()) < MIN_INLIERS || !checkRange(Mat(b_from_a)))
        return false;
    for (const Point2f& p : inliers)
        if (!isUpright(b_from_a, p))
            return false;
    const OverlapLook look = lookAtOverlap(a, b, b_from_a);
    return look.share >= MIN_SHARE && look.windows >= MIN_WINDOWS && look.correlation >= MIN_CORRELATION;
}

std::vector<Vec2i> confirmLinks(LinkedImages& images, const std::vector<Mat>& pictures, double confidence)
{
    const std::vector<int> groups = groupsOf(images, confidence);
    std::vector<Vec2i> pairs;
    for (int a = 0; a < images.count(); ++a)
        for (int b = a + 1; b < images.count(); ++b)
            if (groups[a] != groups[b] && !images.between(a, b).H.empty())
                pairs.emplace_back(a, b);
    std::vector<Vec2i> joined;
    for (const Vec2i& pair : pairs)
    {
        Matx33d b_from_a;
        if (!homographyOf(images, pair[0], pair[1], b_from_a) ||
            !showTheSame(pictures[pair[0]], pictures[pair[1]], b_from_a, linkOf(images, pair[0], pair[1]).points_a))
            continue;
        images.between(pair[0], pair[1]).confidence = images.between(pair[1], pair[0]).confidence = SURE * confidence;
        joined.push_back(pair);
    }
    return joined;
}

} // namespace gcpw
} // namespace cv
