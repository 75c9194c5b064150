// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#include "api/known_matches.hpp"

namespace cv
{
namespace gcpw
{

namespace
{

/// work = (full + 0.5) * scale - 0.5 as a matrix.
Matx33d workFromFull(const FrameScale& scale)
{
    return {scale.x, 0, 0.5 * scale.x - 0.5, 0, scale.y, 0.5 * scale.y - 0.5, 0, 0, 1};
}

Vec4d toFull(const Segment& segment, const FrameScale& scale)
{
    const Point2d start = scale.toFull(segment.start);
    const Point2d end = scale.toFull(segment.end);
    return {start.x, start.y, end.x, end.y};
}

Segment toWork(const Vec4d& line, const FrameScale& scale)
{
    Segment segment;
    segment.start = scale.toWork(Point2d(line[0], line[1]));
    segment.end = scale.toWork(Point2d(line[2], line[3]));
    return segment;
}

} // namespace

Keypoints toWork(const KnownKeypoints& known, const WorkImage& image)
{
    Keypoints result;
    Mat descriptors;
    known.descriptors.convertTo(descriptors, CV_8U);
    const Mat& mask = image.photograph.mask;
    const Rect inside(Point(), image.photograph.image.size());
    const Rect2d around(-1, -1, inside.width + 1, inside.height + 1); // rounding stays within an int
    for (size_t i = 0; i < known.points.size(); ++i)
    {
        const Point2d p = image.scale.toWork(known.points[i]);
        if (!around.contains(p))
            continue;
        const Point pixel(cvRound(p.x), cvRound(p.y));
        if (!inside.contains(pixel) || (!mask.empty() && mask.at<uchar>(pixel) == 0))
            continue;
        result.points.push_back(p);
        result.descriptors.push_back(descriptors.row(static_cast<int>(i)));
    }
    return result;
}

std::vector<Curve> toWork(const std::vector<std::vector<Point2f>>& curves, const WorkImage& image)
{
    std::vector<Curve> result;
    for (const std::vector<Point2f>& points : curves)
    {
        result.emplace_back();
        for (const Point2f& p : points)
            result.back().push_back(image.scale.toWork(p));
    }
    return result;
}

std::vector<PointMatch> toWork(const std::vector<Correspondences>& all, int a, int b,
                               const std::vector<WorkImage>& images)
{
    std::vector<PointMatch> matches;
    for (const Correspondences& item : all)
    {
        const bool straight = item.a == a && item.b == b;
        if (!straight && !(item.a == b && item.b == a))
            continue;
        for (size_t i = 0; i < item.points_a.size(); ++i)
        {
            PointMatch match;
            match.a = images[a].scale.toWork(straight ? item.points_a[i] : item.points_b[i]);
            match.b = images[b].scale.toWork(straight ? item.points_b[i] : item.points_a[i]);
            matches.push_back(match);
        }
    }
    return matches;
}

MatchSet toWork(const PairMatches& matches, MatchKinds kinds, const std::vector<WorkImage>& images)
{
    MatchSet result;
    for (size_t i = 0; kinds.points && i < matches.source_points.size(); ++i)
    {
        PointMatch match;
        match.a = images[0].scale.toWork(matches.source_points[i]);
        match.b = images[1].scale.toWork(matches.target_points[i]);
        result.points.push_back(match);
    }
    for (size_t i = 0; kinds.lines && i < matches.source_lines.size(); ++i)
    {
        LineMatch match;
        match.a = toWork(matches.source_lines[i], images[0].scale);
        match.b = toWork(matches.target_lines[i], images[1].scale);
        match.weight = matches.line_weights[i];
        result.lines.push_back(match);
    }
    return result;
}

Matx33d workHomography(const PairMatches& matches, const std::vector<WorkImage>& images)
{
    return workFromFull(images[1].scale) * matches.target_from_source * workFromFull(images[0].scale).inv();
}

void setMatches(const Matx33d& target_from_source, const MatchSet& matches, const std::vector<WorkImage>& images,
                PairMatches& found)
{
    found.target_from_source = workFromFull(images[1].scale).inv() * target_from_source * workFromFull(images[0].scale);
    for (const PointMatch& match : matches.points)
    {
        found.source_points.push_back(images[0].scale.toFull(match.a));
        found.target_points.push_back(images[1].scale.toFull(match.b));
    }
    for (const LineMatch& match : matches.lines)
    {
        found.source_lines.push_back(toFull(match.a, images[0].scale));
        found.target_lines.push_back(toFull(match.b, images[1].scale));
        found.line_weights.push_back(match.weight);
    }
}

} // namespace gcpw
} // namespace cv
