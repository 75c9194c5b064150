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

/// How far apart a model shows the matched points of links, over the longer side of an image.
struct Misses
{
    double half = 0; ///< what half of the links do not exceed
    double most = 0; ///< what nine of ten do not exceed
};

/** @brief Whether a model explains the links so much better than one before it in the order of trial that it is to be taken.

It must be clearly nearer in most links and no farther in half of them. A single photograph taken from another place spoils the few
links that it has, for one model more than for another; that says nothing about the scene. */
bool isTruer(const Misses& later, const Misses& earlier);

/** @brief Tries camera models in their order and takes the first that makes a picture of sound proportions and shows matched points
together; where it does not quite do that, a later model if it isTruer(). If none is sound, links must
be more certain, and with them images may be left out.
@param confidence of a link  @param forced projection of turning cameras, or empty; "affine" tries flat photographs only */
CameraChoice searchCameras(const LinkedImages& images, double confidence, const WarperMaker& make,
                           const std::string& forced);

} // namespace gcpw
} // namespace cv

#endif
