// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#ifndef OPENCV_GCPW_COLOR_FIELD_HPP
#define OPENCV_GCPW_COLOR_FIELD_HPP

#include <functional>
#include <opencv2/core.hpp>

namespace cv
{
namespace gcpw
{

/** @brief Where a pixel of a picture lies on a colour grid, in quads from the grid's top left corner (0..cols, 0..rows).

Called by several threads at once. */
typedef std::function<Point2f(Point)> GridPosition;

/** @brief The colours of one image as a smooth field: a colour grid, bilinear between quad centres so that no block shows.

An affine map of every channel of YCrCb is an affine map of BGR, and linear in gain and bias. So the grid is turned into maps
of BGR once, and those are read between the centres. Beyond the outer centres the field is constant. */
class ColorField
{
public:
    typedef Vec<float, 12> ColorMap; ///< rows of a 3 x 4 matrix on (B, G, R, 1) in 0..255

    /// @param color rows x cols, CV_32FC(6), as in Alignment::Image
    explicit ColorField(const Mat& color);

    /// The map at a point, in quads as of GridPosition. NaN counts as 0.
    ColorMap at(Point2f quads) const;

    /** @brief Corrects a picture. The same bits whatever the threads.

    Maps are read on every 16th pixel of a row and where the row passes from between some centres to between others, for the
    field bends there; where it runs aslant over small quads, more often. In between they are linear.
    @param picture CV_8UC3, CV_16UC3 or CV_8UC1, changed in place. Gray is taken as a colour without hue
    @param mask CV_8UC1 of its size: pixels outside stay as they are, and have no position; empty for all pixels
    @param position on the grid */
    void apply(Mat& picture, const Mat& mask, const GridPosition& position) const;

private:
    Mat maps_; ///< rows x cols of ColorMap, on the quad centres
};

/** @brief Positions that take time to find: found on every 8th pixel, bilinear in between.
@param picture size of the picture
@param exact position of a pixel; called by one thread, also for a node up to 8 px beyond the picture */
GridPosition positionOnNodes(Size picture, const std::function<Point2d(Point2d)>& exact);

} // namespace gcpw
} // namespace cv

#endif
