// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#ifndef OPENCV_GCPW_BASE_MAPS_HPP
#define OPENCV_GCPW_BASE_MAPS_HPP

#include <functional>
#include <opencv2/stitching/detail/warpers.hpp>

namespace cv
{
namespace gcpw
{

/** @brief The maps that a base warper builds for an image, of any part of its picture.

cv::detail::RotationWarper::buildMaps() makes those of the whole picture, 8 bytes a pixel. The same values, as OpenCV computes them,
but for a base warper of the caller's own: that is asked once, for the whole. */
class BaseMaps
{
public:
    BaseMaps(cv::detail::RotationWarper& base, Size image, const Mat& K, const Mat& R);

    /// The rectangle of the whole picture on the base warper's canvas.
    Rect whole() const { return whole_; }

    /// @param window part of whole()  @param x_map, y_map CV_32FC1 of its size: pixel of the image that each shows
    void build(Rect window, Mat& x_map, Mat& y_map) const;

private:
    Rect whole_;
    std::function<Point2f(int, int)> image_at_; ///< of a pixel of the canvas; empty if the whole maps are there
    Mat x_map_;
    Mat y_map_;
};

} // namespace gcpw
} // namespace cv

#endif
