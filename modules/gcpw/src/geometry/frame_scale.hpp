// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#ifndef OPENCV_GCPW_FRAME_SCALE_HPP
#define OPENCV_GCPW_FRAME_SCALE_HPP

#include <opencv2/core.hpp>

namespace cv
{
namespace gcpw
{

/** @brief The two pixel grids of one frame: `work` pixels per `full` pixel, on each axis.

Scaling acts on pixel squares: work = (full + 0.5) * ratio - 0.5. */
struct FrameScale
{
    double x = 1;
    double y = 1;

    FrameScale() = default;
    FrameScale(Size work, Size full)
        : x(static_cast<double>(work.width) / full.width), y(static_cast<double>(work.height) / full.height)
    {
    }
    Point2d toWork(Point2d full) const { return {(full.x + 0.5) * x - 0.5, (full.y + 0.5) * y - 0.5}; }
    Point2d toFull(Point2d work) const { return {(work.x + 0.5) / x - 0.5, (work.y + 0.5) / y - 0.5}; }
};

} // namespace gcpw
} // namespace cv

#endif
