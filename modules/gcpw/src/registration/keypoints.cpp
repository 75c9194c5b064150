// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#include "registration/keypoints.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include "registration/features_header.hpp"

namespace cv
{
namespace gcpw
{

namespace
{

const double SAME_SPOT = 2.5; ///< px: keypoints closer than this are one spot seen at two scales or orientations
const int DESCRIPTOR_LENGTH = 128;

/// Written over 16-bit differences, which compilers turn into multiply-add instructions.
int squaredDistance(const uchar* a, const uchar* b)
{
    int sum = 0;
    for (int k = 0; k < DESCRIPTOR_LENGTH; ++k)
    {
        const short d = static_cast<short>(a[k] - b[k]);
        sum += d * d;
    }
    return sum;
}

/// The two nearest of the first `count` rows of `descriptors`.
struct Nearest
{
    int index = -1;
    int first = std::numeric_limits<int>::max();
    int second = std::numeric_limits<int>::max();
};

Nearest findNearest(const uchar* query, const Mat& descriptors, int count)
{
    Nearest nearest;
    for (int j = 0; j < count; ++j)
    {
        const int distance = squaredDistance(query, descriptors.ptr<uchar>(j));
        if (distance < nearest.first)
        {
            nearest.second = nearest.first;
            nearest.first = distance;
            nearest.index = j;
        }
        else if (distance < nearest.second)
            nearest.second = distance;
    }
    return nearest;
}

/// Keypoints in square bins, to find those near a point.
class Bins
{
public:
    Bins(const std::vector<Point2d>& points, double size) : points_(points), size_(size)
    {
        for (const Point2d& p : points)
        {
            cols_ = std::max(cols_, binOf(p.x) + 1);
            rows_ = std::max(rows_, binOf(p.y) + 1);
        }
        first_.assign(static_cast<size_t>(cols_) * rows_ + 1, 0);
        for (const Point2d& p : points)
            ++first_[indexOf(p) + 1];
        std::partial_sum(first_.begin(), first_.end(), first_.begin());
        std::vector<int> next(first_.begin(), first_.end() - 1);
        order_.resize(points.size());
        for (size_t i = 0; i < points.size(); ++i)
            order_[next[indexOf(points[i])]++] = static_cast<int>(i);
    }

    template <typename Visit>
    void visit(Point2d centre, double radius, Visit visit) const
    {
        const int left = binOf(centre.x - radius);
        const int right = std::min(binOf(centre.x + radius), cols_ - 1);
        const int bottom = std::min(binOf(centre.y + radius), rows_ - 1);
        for (int row = binOf(centre.y - radius); row <= bottom; ++row)
            for (int col = left; col <= right; ++col)
                for (int i = first_[row * cols_ + col]; i < first_[row * cols_ + col + 1]; ++i)
                {
                    const Point2d d = points_[order_[i]] - centre;
                    if (d.dot(d) <= radius * radius)
                        visit(order_[i]);
                }
    }

private:
    int binOf(double x) const { return static_cast<int>(std::min(std::max(x, 0.0), 1e7) / size_); }
    int indexOf(Point2d p) const { return binOf(p.y) * cols_ + binOf(p.x); }

    const std::vector<Point2d>& points_;
    double size_;
    int cols_ = 1;
    int rows_ = 1;
    std::vector<int> first_;
    std::vector<int> order_;
};

} // namespace

Keypoints detectKeypoints(const Mat& gray, const Mat& mask, Size2d to_reference, double contrast_threshold)
{
    const Ptr<SIFT> sift = SIFT::create(0, 3, contrast_threshold, 10, 1.6, CV_8U);
    std::vector<KeyPoint> found;
    sift->detect(gray, found, mask);
    // A total order, so that the result never depends on how the detector was scheduled.
    std::sort(found.begin(), found.end(), [](const KeyPoint& p, const KeyPoint& q)
    {
        if (p.response != q.response)
            return p.response > q.response;
        if (p.pt.y != q.pt.y)
            return p.pt.y < q.pt.y;
        if (p.pt.x != q.pt.x)
            return p.pt.x < q.pt.x;
        return p.size != q.size ? p.size < q.size : p.angle < q.angle;
    });
    Keypoints result;
    if (!found.empty())
        sift->compute(gray, found, result.descriptors);
    for (const KeyPoint& p : found)
        result.points.emplace_back((p.pt.x + 0.5) * to_reference.width - 0.5, (p.pt.y + 0.5) * to_reference.height - 0.5);
    return result;
}

std::vector<KeypointMatch> matchEverywhere(const Keypoints& a, const Keypoints& b, int strongest, double max_ratio)
{
    std::vector<KeypointMatch> result;
    const int count_a = std::min(strongest, a.descriptors.rows);
    const int count_b = std::min(strongest, b.descriptors.rows);
    if (count_a < 2 || count_b < 2)
        return result;
    std::vector<KeypointMatch> best(count_a);
    parallel_for_(Range(0, count_a), [&](const Range& range)
    {
        for (int i = range.start; i < range.end; ++i)
        {
            const Nearest there = findNearest(a.descriptors.ptr<uchar>(i), b.descriptors, count_b);
            const float ratio = std::sqrt(static_cast<float>(there.first) / std::max(there.second, 1));
            if (!(ratio < max_ratio))
                continue;
            const Nearest back = findNearest(b.descriptors.ptr<uchar>(there.index), a.descriptors, count_a);
            if (back.index != i)
                continue;
            best[i].a = i;
            best[i].b = there.index;
            best[i].ratio = ratio;
        }
    });
    for (const KeypointMatch& match : best)
        if (match.a >= 0)
            result.push_back(match);
    return result;
}

std::vector<KeypointMatch> matchNearby(const Keypoints& a, const Keypoints& b, const Prediction& b_from_a, double radius,
                                       double max_ratio)
{
    const Bins bins(b.points, std::max(radius / 2, 4.0));
    const int none = std::numeric_limits<int>::max();
    std::vector<KeypointMatch> best_of_a(a.points.size());
    std::vector<int> distance_of_a(a.points.size(), none);
    parallel_for_(Range(0, static_cast<int>(a.points.size())), [&](const Range& range)
    {
        std::vector<std::pair<int, int>> candidates; // distance, keypoint
        for (int i = range.start; i < range.end; ++i)
        {
            const auto expected = b_from_a(a.points[i]);
            if (!expected)
                continue;
            candidates.clear();
            const uchar* mine = a.descriptors.ptr<uchar>(i);
            bins.visit(*expected, radius, [&](int j)
            { candidates.emplace_back(squaredDistance(mine, b.descriptors.ptr<uchar>(j)), j); });
            if (candidates.empty())
                continue;
            const auto best = *std::min_element(candidates.begin(), candidates.end());
            int second = none;
            for (const auto& candidate : candidates)
                if (candidate.first < second && norm(b.points[candidate.second] - b.points[best.second]) > SAME_SPOT)
                    second = candidate.first;
            best_of_a[i].a = i;
            best_of_a[i].b = best.second;
            best_of_a[i].ratio = second == none ? 0.0F : std::sqrt(static_cast<float>(best.first) / std::max(second, 1));
            distance_of_a[i] = best.first;
        }
    });
    // Mutual: a keypoint of b belongs to its nearest suitor (the first of equals).
    std::vector<int> suitor(b.points.size(), -1);
    for (size_t i = 0; i < a.points.size(); ++i)
    {
        const int j = best_of_a[i].b;
        if (j >= 0 && (suitor[j] < 0 || distance_of_a[i] < distance_of_a[suitor[j]]))
            suitor[j] = static_cast<int>(i);
    }
    std::vector<KeypointMatch> result;
    for (size_t i = 0; i < a.points.size(); ++i)
        if (best_of_a[i].b >= 0 && suitor[best_of_a[i].b] == static_cast<int>(i) && best_of_a[i].ratio < max_ratio)
            result.push_back(best_of_a[i]);
    return result;
}

std::vector<PointMatch> toPointMatches(const Keypoints& a, const Keypoints& b, const std::vector<KeypointMatch>& matches)
{
    std::vector<PointMatch> points;
    for (const KeypointMatch& match : matches)
    {
        PointMatch point;
        point.a = a.points[match.a];
        point.b = b.points[match.b];
        points.push_back(point);
    }
    return points;
}

} // namespace gcpw
} // namespace cv
