// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#ifndef OPENCV_GCPW_GRAY_PYRAMID_HPP
#define OPENCV_GCPW_GRAY_PYRAMID_HPP

#include <vector>
#include <opencv2/core.hpp>

namespace cv
{
namespace gcpw
{

const int WINDOW = 16; ///< px of a level: side of the square windows by which places are compared

/// The gray levels of a window and one px around it, row by row.
struct WindowPixels
{
    float value[WINDOW + 2][WINDOW + 2];
};

/** @brief Gray levels of an image on levels of halved size, from which windows around any position are read.

A pixel x of a level lies at x * 2^level of the image. Beyond its borders an image goes on as its mirror image. */
class GrayPyramid
{
public:
    GrayPyramid() = default; ///< no levels

    /** @param gray CV_8UC1  @param mask CV_8UC1 of its size, non-zero inside; empty means everywhere
    @param levels at most; none gets smaller than a window */
    GrayPyramid(const Mat& gray, const Mat& mask, int levels);

    int levels() const { return static_cast<int>(padded_.size()); }
    Size size() const { return size_; }
    const Mat& gray() const { return gray_; }
    const Mat& mask() const { return mask_; }

    /// Whether a position is that of a pixel inside the mask.
    bool shows(Point2d image_px) const;

    /** @brief Bilinear gray levels of the window around a position.
    @param centre px of the level  @param step px of the level from one pixel of the window to the next, along its rows and columns
    @param ring how much around the window is read as well, 0 or 1 px
    @return false where the window leaves what is known */
    bool read(int level, Point2d centre, const Matx22d& step, int ring, WindowPixels& window) const;

private:
    bool readUpright(const Mat& image, Point2d first, int ring, WindowPixels& window) const;
    Size size_;
    Mat gray_;
    Mat mask_;
    std::vector<Mat> padded_; ///< CV_32FC1
};

} // namespace gcpw
} // namespace cv

#endif
