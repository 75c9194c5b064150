// Part of the GCPW module for OpenCV. Licence: Apache-2.0 (see LICENSE).
#ifndef OPENCV_GCPW_INVERSE_MAP_HPP
#define OPENCV_GCPW_INVERSE_MAP_HPP

#include "model/mesh_grid.hpp"

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

/// Full-resolution canvas rectangle that holds every pixel whose centre the mesh covers: whole numbers, however large.
Rect2d coveredBounds(const MeshGrid& mesh, const FrameScale& canvas);

/** @brief The same in int. @throws cv::Exception StsOutOfRange if the mesh reaches farther than 1e9 px or is not finite */
Rect coveredRect(const MeshGrid& mesh, const FrameScale& canvas);

/** @brief For every canvas pixel of `roi`, which point of the source it shows.
@param mesh in work pixels on both sides
@param canvas, source scales of the two frames
@param roi full-resolution canvas pixels
@param map CV_32FC2 of roi's size: full-resolution source position; (-1, -1) where the mesh does not cover the centre
@param mask CV_8UC1 of roi's size: 255 exactly where the mesh covers the pixel's centre */
void buildInverseMap(const MeshGrid& mesh, const FrameScale& canvas, const FrameScale& source, Rect roi, Mat& map,
                     Mat& mask);

} // namespace gcpw
} // namespace cv

#endif
