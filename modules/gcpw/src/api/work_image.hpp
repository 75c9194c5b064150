// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#ifndef OPENCV_GCPW_WORK_IMAGE_HPP
#define OPENCV_GCPW_WORK_IMAGE_HPP

#include <vector>
#include "geometry/frame_scale.hpp"
#include "imaging/photograph.hpp"

namespace cv
{
namespace gcpw
{

/// A photograph at the working resolution.
struct WorkImage
{
    Photograph photograph;
    Size full_size;   ///< px as given
    FrameScale scale; ///< working pixels per given pixel
};

/// How photographs are scaled down to a number of pixels. None is scaled up.
enum class ScaleRule
{
    EACH,  ///< by itself, to whole pixels: photographs with frames of their own
    COMMON ///< all by one exact factor, that of the largest: images on one canvas, where positions scale along with them
};

/// One scale for each photograph.
std::vector<FrameScale> frameScales(const std::vector<Size>& full_sizes, double megapix, ScaleRule rule);

/// @param photographs at full resolution
std::vector<WorkImage> toWork(const std::vector<Photograph>& photographs, double megapix, ScaleRule rule);

} // namespace gcpw
} // namespace cv

#endif
