// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#ifndef OPENCV_GCPW_CAMERA_SEARCH_HPP
#define OPENCV_GCPW_CAMERA_SEARCH_HPP

#include <string>
#include <vector>
#include "cameras/camera_models.hpp"
#include "cameras/projection_choice.hpp"

namespace cv
{
namespace gcpw
{

/// The cameras that were taken, and why.
struct CameraChoice
{
    std::vector<int> component;                    ///< of the linked images
    std::vector<cv::detail::CameraParams> cameras; ///< none if no images are linked or nothing sound was found
    CameraModel model = CameraModel::TURNING;
    std::string projection;
    bool turned = false;
    std::vector<std::string> decisions;
};

/** @brief Tries camera models in their order and takes the first that makes a picture of sound proportions and shows matched points
together; where it does not quite do that, a later model if it shows them clearly nearer to each other. If none is sound, links must
be more certain, and with them images may be left out.
@param confidence of a link  @param forced projection of turning cameras, or empty; "affine" tries flat photographs only */
CameraChoice searchCameras(const LinkedImages& images, double confidence, const WarperMaker& make,
                           const std::string& forced);

} // namespace gcpw
} // namespace cv

#endif
