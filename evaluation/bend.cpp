// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#include "evaluation/bend.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <opencv2/imgproc.hpp>
#include "evaluation/spread.hpp"

namespace evaluation
{

namespace
{

using cv::gcpw::AlignedImage;
using cv::gcpw::Rig;

const double MIN_LENGTH = 0.06; ///< of the diagonal
const double STEP = 2;          ///< px between the places where a segment is looked at
const int MIN_STEPS = 8;
const double SLACK = 1;         ///< px by which a segment may lie outside its image: rounding of warpers

/// Canvas position of a point of the image: bilinear in its quad.
cv::Point2d onCanvas(const cv::Mat& grid, cv::Size work, cv::Point2d p)
{
    const int cols = grid.cols - 1;
    const int rows = grid.rows - 1;
    const double u = (p.x + 0.5) / work.width * cols;
    const double v = (p.y + 0.5) / work.height * rows;
    const int j = std::min(std::max(static_cast<int>(u), 0), cols - 1);
    const int i = std::min(std::max(static_cast<int>(v), 0), rows - 1);
    const double a = u - j;
    const double b = v - i;
    const cv::Vec2d top = (1 - a) * grid.at<cv::Vec2d>(i, j) + a * grid.at<cv::Vec2d>(i, j + 1);
    const cv::Vec2d bottom = (1 - a) * grid.at<cv::Vec2d>(i + 1, j) + a * grid.at<cv::Vec2d>(i + 1, j + 1);
    const cv::Vec2d q = (1 - b) * top + b * bottom;
    return {q[0], q[1]};
}

/// Values at equal steps, less their best straight line.
void removeLine(std::vector<double>& values)
{
    const double n = static_cast<double>(values.size());
    double mean = 0;
    double slope = 0;
    double spread = 0;
    for (const double value : values)
        mean += value / n;
    for (size_t i = 0; i < values.size(); ++i)
    {
        const double t = static_cast<double>(i) - 0.5 * (n - 1);
        slope += t * values[i];
        spread += t * t;
    }
    for (size_t i = 0; i < values.size(); ++i)
        values[i] -= mean + slope / spread * (static_cast<double>(i) - 0.5 * (n - 1));
}

/// False if the segment leaves the image.
bool measure(const AlignedImage& image, const cv::Vec4f& segment, const RestMap& rest, SegmentBend& bend)
{
    const cv::Point2d from(segment[0], segment[1]);
    const cv::Point2d along = cv::Point2d(segment[2], segment[3]) - from;
    bend.length = cv::norm(along);
    const int steps = std::max(MIN_STEPS, static_cast<int>(bend.length / STEP));
    std::vector<cv::Point2d>& rough = bend.rough_path;
    for (int k = 0; k <= steps; ++k)
    {
        const cv::Point2d pixel = from + along * (static_cast<double>(k) / steps);
        const cv::Point2d p = rest ? rest(pixel) : pixel;
        const bool inside = p.x >= -SLACK && p.y >= -SLACK && p.x <= image.work_size.width + SLACK &&
                            p.y <= image.work_size.height + SLACK; // false for NaN too
        if (!inside)
            return false;
        rough.push_back(onCanvas(image.rough, image.work_size, p));
        bend.path.push_back(onCanvas(image.mesh, image.work_size, p));
    }
    std::vector<double> across;
    for (size_t k = 0; k < rough.size(); ++k)
    {
        const cv::Point2d tangent = rough[std::min(k + 1, rough.size() - 1)] - rough[k > 0 ? k - 1 : 0];
        across.push_back(tangent.cross(bend.path[k] - rough[k]) / (cv::norm(tangent) + 1e-12));
    }
    removeLine(across);
    for (const double value : across)
    {
        bend.mean_square += value * value / static_cast<double>(across.size());
        bend.largest = std::max(bend.largest, std::abs(value));
    }
    return true;
}

cv::Mat intrinsics(const cv::detail::CameraParams& camera)
{
    cv::Mat K;
    camera.K().convertTo(K, CV_32F);
    return K;
}

/// The base warper whose canvas is that of a rig. Its file does not name it, but its regions tell.
cv::Ptr<cv::PyRotationWarper> baseOf(const Rig& rig)
{
    const double ENOUGH = 4; // canvas px: rounding, and nothing that two different projections would share
    double best = std::numeric_limits<double>::infinity();
    cv::Ptr<cv::PyRotationWarper> found;
    for (const char* name : {"spherical", "cylindrical", "plane", "affine", "fisheye", "stereographic", "mercator",
                             "transverseMercator", "compressedPlaneA2B1", "compressedPlaneA1.5B1", "paniniA2B1", "paniniA1.5B1"})
    {
        const cv::Ptr<cv::PyRotationWarper> warper = cv::makePtr<cv::PyRotationWarper>(name, rig.scale);
        double worst = 0;
        for (int k = 0; k < rig.alignment.imageCount(); ++k)
        {
            if (!rig.turns.empty() && rig.turns[static_cast<size_t>(k)] != 0)
                continue;
            const size_t index = static_cast<size_t>(k);
            const cv::Rect roi = warper->warpRoi(rig.image_sizes[index], intrinsics(rig.cameras[index]), rig.cameras[index].R);
            const cv::Size2d s = rig.alignment.canvasScale();
            const AlignedImage& image = rig.alignment.image(k);
            const cv::Vec2d origin = image.rough.at<cv::Vec2d>(0, 0);
            for (const double miss : {roi.x - (origin[0] + 0.5) / s.width, roi.y - (origin[1] + 0.5) / s.height,
                                      roi.width - image.work_size.width / s.width, roi.height - image.work_size.height / s.height})
                worst = std::max(worst, std::abs(miss));
        }
        if (worst < best)
            found = warper;
        best = std::min(best, worst);
    }
    if (!(best < ENOUGH))
        CV_Error(cv::Error::StsBadArg, cv::format("no warper has the canvas of the rig: the nearest is off by %.1f px", best));
    return found;
}

} // namespace

std::vector<cv::Vec4f> longSegments(const cv::Mat& photograph, cv::Size size)
{
    cv::Mat gray;
    cv::resize(photograph, gray, size, 0, 0, cv::INTER_AREA);
    if (gray.channels() == 3)
        cv::cvtColor(gray, gray, cv::COLOR_BGR2GRAY);
    std::vector<cv::Vec4f> all;
    cv::createLineSegmentDetector(cv::LSD_REFINE_STD)->detect(gray, all);
    std::vector<cv::Vec4f> segments;
    for (const cv::Vec4f& s : all)
        if (std::hypot(s[2] - s[0], s[3] - s[1]) >= MIN_LENGTH * std::hypot(size.width, size.height))
            segments.push_back(s);
    return segments;
}

std::vector<SegmentBend> bendsOf(const AlignedImage& image, const std::vector<cv::Vec4f>& segments, const RestMap& rest)
{
    std::vector<SegmentBend> bends;
    for (const cv::Vec4f& segment : segments)
    {
        SegmentBend bend;
        if (measure(image, segment, rest, bend))
            bends.push_back(bend);
    }
    return bends;
}

Bend summary(const std::vector<SegmentBend>& bends)
{
    Bend result;
    result.segments = static_cast<int>(bends.size());
    double weight = 0;
    int bent = 0;
    std::vector<double> largest;
    for (const SegmentBend& bend : bends)
    {
        result.rms += bend.length * bend.mean_square;
        weight += bend.length;
        bent += bend.largest > VISIBLE_BEND ? 1 : 0;
        largest.push_back(bend.largest);
        result.largest = std::max(result.largest, bend.largest);
    }
    if (bends.empty())
        return result;
    result.rms = std::sqrt(result.rms / weight);
    result.p95 = percentile(largest, 95);
    result.share = 100.0 * bent / result.segments;
    return result;
}

bool moves(const AlignedImage& image)
{
    return cv::norm(image.mesh, image.rough, cv::NORM_INF) > 0;
}

std::vector<std::vector<SegmentBend>> bendsOf(const Rig& rig, const std::function<cv::Mat(int index)>& photographs,
                                              bool still_too)
{
    std::vector<std::vector<SegmentBend>> bends(static_cast<size_t>(rig.alignment.imageCount()));
    cv::Ptr<cv::PyRotationWarper> base;
    for (int k = 0; k < rig.alignment.imageCount(); ++k)
    {
        const AlignedImage& image = rig.alignment.image(k);
        if (!still_too && !moves(image))
            continue;
        if (!base)
            base = baseOf(rig);
        const size_t index = static_cast<size_t>(k);
        const cv::Mat K = intrinsics(rig.cameras[index]);
        const cv::Vec2d origin = image.rough.at<cv::Vec2d>(0, 0);
        const cv::Size2d s = rig.alignment.canvasScale();
        const RestMap rest = [&](cv::Point2d p)
        {
            const cv::Point2d q = base->warpPoint(cv::Point2f(p), K, rig.cameras[index].R);
            return cv::Point2d((q.x + 0.5) * s.width - 1 - origin[0], (q.y + 0.5) * s.height - 1 - origin[1]);
        };
        const cv::Mat photograph = photographs(rig.component.empty() ? k : rig.component[index]);
        bends[index] = bendsOf(image, longSegments(photograph, rig.image_sizes[index]), rest);
    }
    return bends;
}

} // namespace evaluation
