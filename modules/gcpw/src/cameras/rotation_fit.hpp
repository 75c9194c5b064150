// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#ifndef OPENCV_GCPW_ROTATION_FIT_HPP
#define OPENCV_GCPW_ROTATION_FIT_HPP

#include <vector>
#include "cameras/linked_images.hpp"

namespace cv
{
namespace gcpw
{

/// Cameras that only turn, all with one focal length and the principal point in the middle of each image.
struct TurningCameras
{
    double focal = 0;               ///< px
    std::vector<Matx33d> rotations; ///< world from camera
    double cost = 0;                ///< robust mean square of the distances, px^2
};

/** @brief Fits turning cameras to matches (robust bundle adjustment with one focal length).

    sum over links and matches of rho(|p_b - pi(K R_b^T R_a K^-1 p_a)|^2), and the same from b to a,

rho(d^2) = s^2 log(1 + d^2 / s^2): wrong matches and parallax pull little. With 3 n + 1 unknowns there is nothing that runs away where few
matches leave focal lengths of single images undetermined. Several focal lengths are tried as a start; the best result is kept.
@param sizes of the images, px  @param links that connect all of them
@return false if the links connect them not, or no start leads anywhere */
bool fitTurningCameras(const std::vector<Size>& sizes, const std::vector<Link>& links, TurningCameras& cameras);

} // namespace gcpw
} // namespace cv

#endif
