// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#include "registration/segments.hpp"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>
#include <opencv2/ximgproc/fast_line_detector.hpp>

namespace cv
{
namespace gcpw
{

namespace
{

Point2d pixelToReference(double x, double y, Size2d to_reference)
{
    return {(x + 0.5) * to_reference.width - 0.5, (y + 0.5) * to_reference.height - 0.5};
}

const double SIDE = 3; ///< px: how far from a segment the pixels lie that tell its two sides apart

/// Turns a segment so that the brighter side lies to the left of start -> end (image axes).
void direct(Segment& segment, const Mat& gray)
{
    const Point2d d = segment.direction() / segment.length();
    const Point2d left(d.y, -d.x);
    double difference = 0;
    for (int k = 1; k < 8; ++k)
        for (const double offset : {SIDE / 2, SIDE})
        {
            const Point2d p = segment.at(k / 8.0);
            const auto read = [&](Point2d q)
            {
                const int x = std::min(std::max(cvRound(q.x), 0), gray.cols - 1);
                const int y = std::min(std::max(cvRound(q.y), 0), gray.rows - 1);
                return static_cast<int>(gray.at<uchar>(y, x));
            };
            difference += read(p + offset * left) - read(p - offset * left);
        }
    if (difference < 0)
        std::swap(segment.start, segment.end);
}

std::vector<Vec4f> detect(const Mat& gray, SegmentDetector detector, int shortest)
{
    std::vector<Vec4f> found;
    if (detector == SegmentDetector::LSD)
        createLineSegmentDetector(LSD_REFINE_STD)->detect(gray, found);
    else
        ximgproc::createFastLineDetector(shortest)->detect(gray, found);
    found.erase(std::remove_if(found.begin(), found.end(),
                               [=](const Vec4f& f) { return std::hypot(f[2] - f[0], f[3] - f[1]) < static_cast<float>(shortest); }),
                found.end());
    return found;
}

/// The pixels around which everything within SIDE is valid; beyond the image's border nothing is asked for.
Mat withSides(const Mat& mask)
{
    if (mask.empty())
        return mask;
    const int size = 2 * cvCeil(SIDE) + 1;
    Mat inner;
    erode(mask, inner, getStructuringElement(MORPH_RECT, Size(size, size)), Point(-1, -1), 1, BORDER_CONSTANT,
          Scalar::all(255));
    return inner;
}

/// The longest part of a segment whose points, looked at every px, are all inside; of equals the first. Without length if
/// there is none.
template <typename Inside>
Segment longestPart(const Segment& segment, Inside inside)
{
    const int steps = std::max(cvCeil(segment.length()), 1);
    const auto at = [&](int k) { return segment.at(static_cast<double>(k) / steps); };
    int first = 0;
    int longest = 0;
    int run = 0;
    for (int k = 0; k <= steps; ++k)
    {
        run = inside(at(k)) ? run + 1 : 0;
        if (run > longest)
        {
            longest = run;
            first = k + 1 - run;
        }
    }
    if (longest == steps + 1)
        return segment;
    return {at(first), at(first + std::max(longest - 1, 0))};
}

/// The part of a segment whose sides a mask shows.
Segment clipped(const Segment& segment, const Mat& inner)
{
    return longestPart(segment, [&](Point2d p)
    {
        const int x = std::min(std::max(cvRound(p.x), 0), inner.cols - 1);
        const int y = std::min(std::max(cvRound(p.y), 0), inner.rows - 1);
        return inner.at<uchar>(y, x) != 0;
    });
}

/// What image b shows of a segment of a.
struct Shown
{
    Segment part;     ///< of the segment
    Segment expected; ///< that part in b; without length where there is none
};

Shown shownBy(const Segment& segment, const Prediction& b_from_a, double least)
{
    const auto start = b_from_a(segment.start);
    const auto end = b_from_a(segment.end);
    if (start && end)
        return {segment, {*start, *end}};
    const Segment part = longestPart(segment, [&](Point2d p) { return b_from_a(p).has_value(); });
    if (!(part.length() >= least))
        return Shown();
    return {part, {*b_from_a(part.start), *b_from_a(part.end)}};
}

struct Candidate
{
    double distance;
    double shared; ///< common length over the longer one's
    int a;
    int b;
};

} // namespace

std::vector<Segment> detectSegments(const Mat& gray, const Mat& mask, Size2d to_reference, double min_length,
                                    SegmentDetector detector)
{
    CV_DbgAssert(mask.empty() || (mask.type() == CV_8UC1 && mask.size() == gray.size()));
    const double to_pixels = 1 / std::max(to_reference.width, to_reference.height);
    const int shortest = std::max(cvRound(min_length * to_pixels), 5);
    std::vector<Vec4f> found;
    if (std::min(gray.cols, gray.rows) > 2 * shortest)
        found = detect(gray, detector, shortest);
    const Mat inner = withSides(mask);
    std::vector<Segment> segments;
    for (const Vec4f& f : found)
    {
        Segment segment{Point2d(f[0], f[1]), Point2d(f[2], f[3])};
        if (!inner.empty())
        {
            const double whole = segment.length();
            segment = clipped(segment, inner);
            if (segment.length() < whole && segment.length() < shortest)
                continue;
        }
        if (!(segment.length() > 1))
            continue;
        direct(segment, gray);
        segment.start = pixelToReference(segment.start.x, segment.start.y, to_reference);
        segment.end = pixelToReference(segment.end.x, segment.end.y, to_reference);
        segments.push_back(segment);
    }
    std::stable_sort(segments.begin(), segments.end(),
                     [](const Segment& p, const Segment& q) { return p.length() > q.length(); });
    return segments;
}

std::vector<LineMatch> matchSegments(const std::vector<Segment>& a, const std::vector<Segment>& b,
                                     const Prediction& b_from_a, const SegmentTolerance& tolerance)
{
    std::vector<Candidate> candidates;
    std::vector<Segment> parts;
    for (size_t i = 0; i < a.size(); ++i)
    {
        const Shown shown = shownBy(a[i], b_from_a, tolerance.crossing);
        const Segment& expected = shown.expected;
        parts.push_back(shown.part);
        const double expected_length = expected.length();
        if (!(expected_length > 1))
            continue;
        for (size_t j = 0; j < b.size(); ++j)
        {
            const double length = b[j].length();
            const Point2d d = b[j].direction() / length;
            const Point2d e = expected.direction() / expected_length;
            if (!(e.dot(d) > 0) || !(std::abs(e.cross(d)) < std::sin(tolerance.angle)))
                continue;
            // The common part, along b.
            const double t0 = (expected.start - b[j].start).dot(d);
            const double t1 = (expected.end - b[j].start).dot(d);
            const double low = std::max(t0, 0.0);
            const double high = std::min(t1, length);
            if (!(high - low >= tolerance.overlap * std::min(length, t1 - t0)))
                continue;
            const Line line = b[j].line();
            const double r0 = line.distance(expected.at((low - t0) / (t1 - t0)));
            const double r1 = line.distance(expected.at((high - t0) / (t1 - t0)));
            const double distance = std::sqrt((r0 * r0 + r0 * r1 + r1 * r1) / 3);
            if (distance <= tolerance.distance)
                candidates.push_back({distance, (high - low) / std::max(length, t1 - t0), static_cast<int>(i),
                                      static_cast<int>(j)});
        }
    }
    std::sort(candidates.begin(), candidates.end(), [](const Candidate& p, const Candidate& q)
    {
        const double cost_p = p.distance - p.shared; // a px of distance weighs like the whole length in common
        const double cost_q = q.distance - q.shared;
        if (cost_p != cost_q)
            return cost_p < cost_q;
        return p.a != q.a ? p.a < q.a : p.b < q.b;
    });
    std::vector<bool> used_a(a.size(), false);
    std::vector<bool> used_b(b.size(), false);
    std::vector<LineMatch> matches;
    for (const Candidate& c : candidates)
    {
        if (used_a[c.a] || used_b[c.b])
            continue;
        used_a[c.a] = used_b[c.b] = true;
        LineMatch match;
        match.a = parts[c.a];
        match.b = b[c.b];
        match.weight = c.shared;
        matches.push_back(match);
    }
    return matches;
}

} // namespace gcpw
} // namespace cv
