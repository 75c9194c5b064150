// Part of the GCPW module for OpenCV. Licence: Apache-2.0 (see LICENSE).
#include "pipeline/image_graph.hpp"

#include <algorithm>
#include <numeric>

namespace cv
{
namespace gcpw
{

namespace
{

const int MIN_AREA = 400;      ///< px: a smaller overlap holds no quad and says nothing
const double MIN_SHARE = 0.01; ///< of the smaller image

int sharedArea(Point corner_a, const Mat& a, Point corner_b, const Mat& b)
{
    const Rect shared = Rect(corner_a, a.size()) & Rect(corner_b, b.size());
    return shared.area() < MIN_AREA ? 0 : countNonZero(a(shared - corner_a) & b(shared - corner_b));
}

} // namespace

std::vector<Overlap> findOverlaps(const std::vector<Point>& corners, const std::vector<Mat>& masks, int period)
{
    CV_Assert(corners.size() == masks.size());
    std::vector<Overlap> overlaps;
    for (size_t i = 0; i < masks.size(); ++i)
        for (size_t j = i + 1; j < masks.size(); ++j)
        {
            // Corners may lie anywhere: the turns that bring b nearest to a, and one to either side of that.
            const int nearest = period > 0 ? cvRound(static_cast<double>(corners[i].x - corners[j].x) / period) : 0;
            for (int turns = nearest - (period > 0 ? 1 : 0); turns <= nearest + (period > 0 ? 1 : 0); ++turns)
            {
                const int area = sharedArea(corners[i], masks[i], corners[j] + Point(turns * period, 0), masks[j]);
                const double smaller = static_cast<double>(std::min(masks[i].total(), masks[j].total()));
                if (area >= MIN_AREA && area >= MIN_SHARE * smaller)
                    overlaps.push_back({static_cast<int>(i), static_cast<int>(j), turns, area});
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
        const Point corner[2] = {corners[overlap.a], corners[overlap.b] + Point(overlap.turns_b * period, 0)};
        const int image[2] = {overlap.a, overlap.b};
        const Rect shared = Rect(corner[0], masks[image[0]].size()) & Rect(corner[1], masks[image[1]].size());
        const Mat both = masks[image[0]](shared - corner[0]) & masks[image[1]](shared - corner[1]);
        for (int side = 0; side < 2; ++side)
        {
            const Mat count = compared[image[side]](shared - corner[side]);
            taken[k] = taken[k] || 2 * countNonZero((count < enough) & both) > overlap.area;
        }
        for (int side = 0; side < 2 && taken[k]; ++side)
        {
            Mat count = compared[image[side]](shared - corner[side]);
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
