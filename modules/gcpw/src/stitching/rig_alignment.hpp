// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#ifndef OPENCV_GCPW_RIG_ALIGNMENT_HPP
#define OPENCV_GCPW_RIG_ALIGNMENT_HPP

#include <string>
#include <vector>
#include "opencv2/gcpw/rig.hpp"

namespace cv
{
namespace gcpw
{

/// A rig, usable or with the reason why not.
struct RigEstimate
{
    Rig rig;
    bool lasting = true; ///< the same images would give the same again: neither cancelled nor short of memory
};

/// A rig without meshes, whose report says why.
Rig rigWithoutAnswer(const std::vector<cv::detail::CameraParams>& cameras, const std::string& reason);

/// Tells the log why a rig is of no use.
void logReason(const Rig& rig);

/** @brief alignRig() for callers who cannot stop half way: whatever fails becomes a reason.

Throws nothing but what `progress` throws. */
RigEstimate estimateRig(const std::vector<Mat>& images, const std::vector<cv::detail::CameraParams>& cameras,
                        const Ptr<WarperCreator>& base, const Params& params, const Progress& progress,
                        const std::vector<KnownKeypoints>& keypoints);

} // namespace gcpw
} // namespace cv

#endif
