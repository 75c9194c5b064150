// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#include "overlap/overlap_samples.hpp"

#include <algorithm>
#include <opencv2/imgproc.hpp>

namespace cv
{
namespace gcpw
{

namespace
{

const float INSIDE = 0.98F;           ///< least mask value of a source pixel that is sampled
const int CONTRAST_WINDOW = 5;        ///< px, that of the scores
const double TYPICAL_VARIANCE = 0.01; ///< of Y at an edge: there the importance is about one, so lambda_1 keeps its meaning

/// Importance of every pixel: noise and strong edges say little more than faint texture does.
Mat importanceOf(const PyramidLevel& level, double floor)
{
    Mat luma;
    extractChannel(level.pixels, luma, 0);
    Mat mean;
    Mat squares;
    const Size window(CONTRAST_WINDOW, CONTRAST_WINDOW);
    blur(luma, mean, window);
    blur(luma.mul(luma), squares, window);
    const Mat variance = max(squares - mean.mul(mean), 0.0);
    return TYPICAL_VARIANCE / (variance + floor * floor);
}

struct Found
{
    CellPoint point;
    Point pixel;
};

std::vector<Found> findSamples(const PyramidLevel& source, const Lattice& lattice, int step)
{
    std::vector<Found> found;
    for (int y = step / 2; y < source.pixels.rows; y += step)
        for (int x = step / 2; x < source.pixels.cols; x += step)
        {
            const Point2d reference(x * source.scale, y * source.scale);
            if (source.at(x, y)[3] >= INSIDE && lattice.contains(reference))
                found.push_back({lattice.locate(reference), Point(x, y)});
        }
    return found;
}

} // namespace

OverlapSamples::OverlapSamples(int source_image, int target_image, const PyramidLevel& source, const PyramidLevel& target,
                               const Lattice& lattice, int step, double contrast_floor, Point2d target_shift)
    : source_image_(source_image), target_image_(target_image), target_(target), lattice_(lattice),
      target_shift_(target_shift), first_(lattice.cellCount() + 1, 0)
{
    CV_CheckGT(step, 0, "Samples of an overlap need a positive step");
    CV_Assert(source.scale == target.scale);
    const std::vector<Found> found = findSamples(source, lattice, step);
    // Counting sort by cell: the samples of a quad lie together and keep their order.
    for (const Found& f : found)
        ++first_[f.point.cell + 1];
    for (int cell = 0; cell < lattice.cellCount(); ++cell)
        first_[cell + 1] += first_[cell];
    const Mat importance = contrast_floor > 0 ? importanceOf(source, contrast_floor) : Mat();
    std::vector<int> next(first_.begin(), first_.end() - 1);
    samples_.resize(found.size());
    for (const Found& f : found)
    {
        Sample& sample = samples_[next[f.point.cell]++];
        const float* pixel = source.at(f.pixel.x, f.pixel.y);
        for (int k = 0; k < 4; ++k)
            sample.weight[k] = static_cast<float>(f.point.weight[k]);
        std::copy(pixel, pixel + 3, sample.value);
        sample.importance = importance.empty() ? 1.0F : importance.at<float>(f.pixel);
    }
}

} // namespace gcpw
} // namespace cv
