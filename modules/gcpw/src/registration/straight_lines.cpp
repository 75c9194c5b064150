// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#include "registration/straight_lines.hpp"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>
#include "registration/segments.hpp"

namespace cv
{
namespace gcpw
{

namespace
{

const double LEAST_LINE = 0.03;   ///< of the diagonal: shorter ones are not seen to bend
const double LEAST_SEGMENT = 12;   ///< px of a piece of a line
const double MAX_TURN = 0.035;     ///< radians between segments of one line: 2 degrees
const double MAX_OFFSET = 1.5;     ///< px from the line through both: what detectors leave between pieces of one edge
const double MAX_GAP = 0.5;        ///< of the length of both together; beyond it two edges may lie on one line by chance
const double BESIDE = 4;           ///< px: lines this close bend together, as one quad of a mesh holds both
const double COVERED = 0.9;        ///< of a line that lies beside a longer one
const size_t MAX_LINES = 400;      ///< of an image: more hold no more of it, and each costs time

/// Where b lies as seen from a: along a, from its start, px.
struct Extent
{
    double low;
    double high;
};

Extent along(const Segment& a, const Segment& b)
{
    const Point2d d = a.direction() / a.length();
    const double s = (b.start - a.start).dot(d);
    const double e = (b.end - a.start).dot(d);
    return {std::min(s, e), std::max(s, e)};
}

bool isParallel(const Segment& a, const Segment& b)
{
    return std::abs(a.direction().cross(b.direction())) <= std::sin(MAX_TURN) * a.length() * b.length();
}

double farthestFrom(const Segment& line, const Segment& other)
{
    const Line l = line.line();
    return std::max(std::abs(l.distance(other.start)), std::abs(l.distance(other.end)));
}

/// The segment from the first to the last end of both, seen along the longer one.
Segment joined(const Segment& a, const Segment& b)
{
    const Point2d d = a.direction() / a.length();
    Point2d ends[] = {a.start, a.end, b.start, b.end};
    const auto before = [&](Point2d p, Point2d q) { return p.dot(d) < q.dot(d); };
    return {*std::min_element(ends, ends + 4, before), *std::max_element(ends, ends + 4, before)};
}

bool isOneLine(const Segment& a, const Segment& b)
{
    if (!isParallel(a, b))
        return false;
    const Extent extent = along(a, b);
    const double gap = std::max(extent.low - a.length(), -extent.high);
    if (gap > MAX_GAP * (a.length() + b.length()))
        return false;
    const Segment whole = joined(a, b);
    return farthestFrom(whole, a) <= MAX_OFFSET && farthestFrom(whole, b) <= MAX_OFFSET;
}

bool isBeside(const Segment& longer, const Segment& shorter)
{
    if (!isParallel(longer, shorter) || farthestFrom(longer, shorter) > BESIDE)
        return false;
    const Extent extent = along(longer, shorter);
    return std::min(extent.high, longer.length()) - std::max(extent.low, 0.0) >= COVERED * shorter.length();
}

void sortByLength(std::vector<Segment>& segments)
{
    std::stable_sort(segments.begin(), segments.end(),
                     [](const Segment& p, const Segment& q) { return p.length() > q.length(); });
}

} // namespace

std::vector<Segment> findStraightLines(const Mat& image, const Mat& mask)
{
    Mat gray;
    cvtColor(image, gray, COLOR_BGR2GRAY);
    return joinSegments(detectSegments(gray, mask, Size2d(1, 1), LEAST_SEGMENT, SegmentDetector::LSD),
                        LEAST_LINE * std::hypot(gray.cols, gray.rows));
}

std::vector<Segment> bordersOf(Size image)
{
    const Point2d corners[] = {Point2d(0, 0), Point2d(image.width - 1, 0), Point2d(image.width - 1, image.height - 1),
                               Point2d(0, image.height - 1)};
    std::vector<Segment> borders;
    for (int k = 0; k < 4; ++k)
        borders.push_back({corners[k], corners[(k + 1) % 4]});
    return borders;
}

std::vector<Segment> joinSegments(const std::vector<Segment>& segments, double min_length)
{
    std::vector<Segment> left;
    for (const Segment& segment : segments)
        if (segment.length() > 0 && std::isfinite(segment.length()))
            left.push_back(segment);
    sortByLength(left);
    std::vector<Segment> lines;
    std::vector<bool> used(left.size(), false);
    for (size_t i = 0; i < left.size(); ++i)
    {
        if (used[i])
            continue;
        Segment line = left[i];
        for (bool grown = true; grown;)
        {
            grown = false;
            for (size_t j = i + 1; j < left.size(); ++j)
                if (!used[j] && isOneLine(line, left[j]))
                {
                    line = joined(line, left[j]);
                    used[j] = grown = true;
                }
        }
        if (line.length() >= min_length)
            lines.push_back(line);
    }
    sortByLength(lines);
    std::vector<Segment> kept;
    for (const Segment& line : lines)
        if (kept.size() < MAX_LINES &&
            std::none_of(kept.begin(), kept.end(), [&](const Segment& longer) { return isBeside(longer, line); }))
            kept.push_back(line);
    return kept;
}

} // namespace gcpw
} // namespace cv
