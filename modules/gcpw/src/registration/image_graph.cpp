// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#include "registration/image_graph.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace cv
{
namespace gcpw
{

namespace
{

const int MIN_AREA = 400;      ///< px: a smaller overlap is less than a quad
const double MIN_SHARE = 0.01; ///< of the smaller image

/// What two images share, in the pixels of each of them.
struct Shared
{
    Rect in_a;
    Rect in_b;
};

/// @param shift_b px to the right at which b is seen
Shared sharedOf(Point corner_a, Size a, Point corner_b, Size b, int64 shift_b)
{
    // In 64 bits: corners may lie anywhere. What is shared lies inside an image.
    const int64 x = static_cast<int64>(corner_b.x) + shift_b - corner_a.x;
    const int64 y = static_cast<int64>(corner_b.y) - corner_a.y;
    const int64 left = std::max<int64>(x, 0);
    const int64 top = std::max<int64>(y, 0);
    const int64 width = std::min<int64>(x + b.width, a.width) - left;
    const int64 height = std::min<int64>(y + b.height, a.height) - top;
    if (width <= 0 || height <= 0)
        return {};
    const Size size(static_cast<int>(width), static_cast<int>(height));
    return {Rect(Point(static_cast<int>(left), static_cast<int>(top)), size),
            Rect(Point(static_cast<int>(left - x), static_cast<int>(top - y)), size)};
}

int sharedArea(const Shared& shared, const Mat& a, const Mat& b)
{
    const double area = static_cast<double>(shared.in_a.width) * shared.in_a.height;
    return area < MIN_AREA ? 0 : countNonZero(a(shared.in_a) & b(shared.in_b));
}

/// The number of periods that brings x nearest to 0; may exceed an int.
int64 nearestTurns(int64 x, int period)
{
    return period > 0 ? static_cast<int64>(std::nearbyint(static_cast<double>(x) / period)) : 0;
}

} // namespace

std::vector<Overlap> findOverlaps(const std::vector<Point>& corners, const std::vector<Mat>& masks, int period)
{
    CV_Assert(corners.size() == masks.size() && period >= 0);
    std::vector<Overlap> overlaps;
    for (size_t i = 0; i < masks.size(); ++i)
        for (size_t j = i + 1; j < masks.size(); ++j)
        {
            // Corners may lie anywhere: the periods that bring b nearest to a, and one more to either side.
            const int64 nearest = nearestTurns(static_cast<int64>(corners[i].x) - corners[j].x, period);
            for (int64 turns = nearest - (period > 0 ? 1 : 0); turns <= nearest + (period > 0 ? 1 : 0); ++turns)
            {
                const int area = sharedArea(sharedOf(corners[i], masks[i].size(), corners[j], masks[j].size(), turns * period), masks[i], masks[j]);
                const double smaller = static_cast<double>(std::min(masks[i].total(), masks[j].total()));
                if (area >= MIN_AREA && area >= MIN_SHARE * smaller)
                    overlaps.push_back({static_cast<int>(i), static_cast<int>(j), static_cast<int>(turns), area});
            }
        }
    return overlaps;
}

std::vector<Overlap> withoutRepetition(const std::vector<Overlap>& overlaps, const std::vector<Point>& corners,
                                       const std::vector<Mat>& masks, int period, int enough)
{
    std::vector<size_t> order(overlaps.size());
    std::iota(order.begin(), order.end(), size_t(0));
    std::stable_sort(order.begin(), order.end(), [&](size_t i, size_t j) { return overlaps[i].area > overlaps[j].area; });
    std::vector<Mat> compared; // how often each pixel is
    for (const Mat& mask : masks)
        compared.push_back(Mat::zeros(mask.size(), CV_8U));
    std::vector<bool> taken(overlaps.size(), false);
    for (const size_t k : order)
    {
        const Overlap& overlap = overlaps[k];
        const int image[2] = {overlap.a, overlap.b};
        const Shared shared = sharedOf(corners[overlap.a], masks[overlap.a].size(), corners[overlap.b], masks[overlap.b].size(),
                                       static_cast<int64>(overlap.period_offset_b) * period);
        const Rect part[2] = {shared.in_a, shared.in_b};
        const Mat both = masks[overlap.a](part[0]) & masks[overlap.b](part[1]);
        for (int side = 0; side < 2; ++side)
        {
            const Mat count = compared[image[side]](part[side]);
            taken[k] = taken[k] || 2 * countNonZero((count < enough) & both) > overlap.area;
        }
        for (int side = 0; side < 2 && taken[k]; ++side)
        {
            Mat count = compared[image[side]](part[side]);
            add(count, 1, count, both);
        }
    }
    std::vector<Overlap> result;
    for (size_t k = 0; k < overlaps.size(); ++k)
        if (taken[k])
            result.push_back(overlaps[k]);
    return result;
}

int mostCentral(int images, const std::vector<Overlap>& overlaps)
{
    std::vector<std::vector<int>> neighbours(images);
    std::vector<double> area(images, 0);
    for (const Overlap& overlap : overlaps)
    {
        neighbours[overlap.a].push_back(overlap.b);
        neighbours[overlap.b].push_back(overlap.a);
        area[overlap.a] += overlap.area;
        area[overlap.b] += overlap.area;
    }
    int best = 0;
    int best_sum = -1;
    for (int root = 0; root < images; ++root)
    {
        // Breadth first; an image out of reach counts as farther than any path.
        std::vector<int> distance(images, images);
        std::vector<int> queue(1, root);
        distance[root] = 0;
        for (size_t k = 0; k < queue.size(); ++k)
            for (int next : neighbours[queue[k]])
                if (distance[next] == images)
                {
                    distance[next] = distance[queue[k]] + 1;
                    queue.push_back(next);
                }
        int sum = 0;
        for (int d : distance)
            sum += d;
        if (best_sum < 0 || sum < best_sum || (sum == best_sum && area[root] > area[best]))
        {
            best = root;
            best_sum = sum;
        }
    }
    return best;
}

} // namespace gcpw
} // namespace cv
