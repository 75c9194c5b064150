// Part of the GCPW module for OpenCV. Licence: Apache-2.0 (see LICENSE).
#include "matching/segments.hpp"

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

Point2d pixelToRest(double x, double y, Size2d to_rest)
{
    return {(x + 0.5) * to_rest.width - 0.5, (y + 0.5) * to_rest.height - 0.5};
}

/// Turns a segment so that the brighter side lies to the left of start -> end (image axes).
void direct(Segment& segment, const Mat& gray)
{
    const Point2d d = segment.direction() / segment.length();
    const Point2d left(d.y, -d.x);
    double difference = 0;
    for (int k = 1; k < 8; ++k)
        for (double offset = 1.5; offset <= 3; offset += 1.5)
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

struct Candidate
{
    double distance;
    double shared; ///< common length over the longer one's
    int a;
    int b;
};

} // namespace

std::vector<Segment> detectSegments(const Mat& gray, Size2d to_rest, double min_length)
{
    const double to_pixels = 1 / std::max(to_rest.width, to_rest.height);
    const int shortest = std::max(cvRound(min_length * to_pixels), 5);
    const Ptr<ximgproc::FastLineDetector> detector = ximgproc::createFastLineDetector(shortest);
    std::vector<Vec4f> found;
    if (std::min(gray.cols, gray.rows) > 2 * shortest)
        detector->detect(gray, found);
    std::vector<Segment> segments;
    for (const Vec4f& f : found)
    {
        Segment segment{Point2d(f[0], f[1]), Point2d(f[2], f[3])};
        if (!(segment.length() > 1))
            continue;
        direct(segment, gray);
        segment.start = pixelToRest(segment.start.x, segment.start.y, to_rest);
        segment.end = pixelToRest(segment.end.x, segment.end.y, to_rest);
        segments.push_back(segment);
    }
    std::stable_sort(segments.begin(), segments.end(),
                     [](const Segment& p, const Segment& q) { return p.length() > q.length(); });
    return segments;
}

std::vector<LineMatch> matchSegments(const std::vector<Segment>& a, const std::vector<Segment>& b,
                                     const std::function<Point2d(Point2d)>& b_from_a, const SegmentTolerance& tolerance)
{
    std::vector<Candidate> candidates;
    for (size_t i = 0; i < a.size(); ++i)
    {
        const Segment expected{b_from_a(a[i].start), b_from_a(a[i].end)};
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
        match.a = a[c.a];
        match.b = b[c.b];
        match.weight = c.shared;
        matches.push_back(match);
    }
    return matches;
}

} // namespace gcpw
} // namespace cv
