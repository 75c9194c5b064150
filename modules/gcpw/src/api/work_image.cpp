// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#include "api/work_image.hpp"

#include <algorithm>
#include <cmath>

namespace cv
{
namespace gcpw
{

std::vector<FrameScale> frameScales(const std::vector<Size>& full_sizes, double megapix, ScaleRule rule)
{
    std::vector<FrameScale> scales(full_sizes.size());
    double largest = 1;
    for (const Size& full : full_sizes)
        largest = std::max(largest, static_cast<double>(full.width) * full.height);
    const double factor = std::min(1.0, std::sqrt(megapix * 1e6 / largest));
    for (size_t i = 0; i < scales.size(); ++i)
    {
        if (rule == ScaleRule::EACH)
            scales[i] = FrameScale(cappedSize(full_sizes[i], megapix), full_sizes[i]);
        else
            scales[i].x = scales[i].y = factor;
    }
    return scales;
}

std::vector<WorkImage> toWork(const std::vector<Photograph>& photographs, double megapix, ScaleRule rule)
{
    std::vector<Size> full_sizes;
    for (const Photograph& photograph : photographs)
        full_sizes.push_back(photograph.image.size());
    const std::vector<FrameScale> scales = frameScales(full_sizes, megapix, rule);
    std::vector<WorkImage> images;
    for (size_t i = 0; i < photographs.size(); ++i)
        images.push_back({resized(photographs[i], scales[i]), full_sizes[i], scales[i]});
    return images;
}

} // namespace gcpw
} // namespace cv
