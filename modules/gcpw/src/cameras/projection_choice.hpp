// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#ifndef OPENCV_GCPW_PROJECTION_CHOICE_HPP
#define OPENCV_GCPW_PROJECTION_CHOICE_HPP

#include <functional>
#include <string>
#include <vector>
#include "cameras/picture_shape.hpp"
#include "cameras/straighten.hpp"

namespace cv
{
namespace gcpw
{

/// Makes the warper of a name and a scale.
typedef std::function<Ptr<cv::detail::RotationWarper>(const std::string& name, float scale)> WarperMaker;

/// A projection for some cameras, and the frame of the world in which it is used.
struct ProjectionChoice
{
    std::string name;               ///< "plane", "spherical", "stereographic"
    Matx33d world = Matx33d::eye(); ///< to be multiplied from the left onto every rotation
    bool turned = false;            ///< the picture comes out turned to the left by 90 degrees
    SetShape set_shape = SetShape::SPOT;
    bool straight = true; ///< along the strip or column; otherwise about the middle of the view
    PictureShape picture; ///< what it will be like
};

/** @brief Chooses the projection of turning cameras by how much it enlarges their photographs.

The plane, which keeps straight lines, where it does so little; else the sphere along the strip or the column of the photographs;
else, for sets that reach its poles, the sphere and then the stereographic projection about the middle of the view.
@param forced if not empty, the only projection to be tried */
ProjectionChoice chooseProjection(const std::vector<cv::detail::CameraParams>& cameras, const std::vector<Size>& sizes,
                                  const WarperMaker& make, const std::string& forced = std::string());

/// Cameras in another frame of the world.
std::vector<cv::detail::CameraParams> inWorld(const Matx33d& world,
                                              const std::vector<cv::detail::CameraParams>& cameras);

} // namespace gcpw
} // namespace cv

#endif
