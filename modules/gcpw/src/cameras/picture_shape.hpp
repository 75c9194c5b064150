// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#ifndef OPENCV_GCPW_PICTURE_SHAPE_HPP
#define OPENCV_GCPW_PICTURE_SHAPE_HPP

#include <string>
#include <vector>
#include <opencv2/stitching/detail/camera.hpp>
#include <opencv2/stitching/detail/warpers.hpp>
#include "cameras/linked_images.hpp"
#include "opencv2/gcpw/cameras.hpp" // medianFocal()

namespace cv
{
namespace gcpw
{

/// What a picture by some cameras and a projection would be like, found before it is made.
struct PictureShape
{
    double stretch =
        0; ///< largest enlargement of a pixel of any photograph in any direction, over the picture's own scale
    double shrink = 0; ///< smallest
    double area = 0;   ///< of the picture, over all photographs together
    Size size;         ///< at the resolution of the cameras, px
    std::string fault; ///< what is out of proportion, in words; empty for nothing
};

/** @brief Measures the picture.
@param warper of scale medianFocal()
@param period of the canvas in x, 0 if it does not repeat: an image across its seam is no larger for that */
PictureShape shapeOfPicture(const std::vector<cv::detail::CameraParams>& cameras, const std::vector<Size>& sizes,
                            cv::detail::RotationWarper& warper, double period);

/** @brief Median distance in pixels of the photographs between where a warper shows the two points of a match, for each link.
@param period of the canvas in x, 0 if it does not repeat */
std::vector<double> missesOf(const std::vector<cv::detail::CameraParams>& cameras, const std::vector<Link>& links,
                             cv::detail::RotationWarper& warper, double period);

} // namespace gcpw
} // namespace cv

#endif
