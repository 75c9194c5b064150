// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#ifndef OPENCV_GCPW_SHARED_STATE_HPP
#define OPENCV_GCPW_SHARED_STATE_HPP

#include <algorithm>
#include <functional>
#include <memory>
#include <vector>
#include "stitching/rig_model.hpp"

namespace cv
{
namespace gcpw
{

/// State that the creator of warpers, the compensator and the stitcher's binding share.
struct SharedState
{
    Ptr<WarperCreator> base;
    Rig rig;
    std::shared_ptr<const RigModel> model;            ///< of the rig; empty if it is not usable
    std::vector<float> scales;                        ///< of the warpers made, latest first, each once
    std::weak_ptr<cv::detail::RotationWarper> warper; ///< made last: cv::Stitcher keeps it until its panorama is done
    std::function<void()> before_create; ///< called before each warper is made: the binding estimates here; may be empty
    std::function<void()> before_feed;   ///< called before feed(): the binding checks the stitcher's parts here; may be empty

    void setRig(const Rig& new_rig)
    {
        // The model first: if there is no memory for it, the former rig stays.
        const std::shared_ptr<const RigModel> new_model = RigModel::create(new_rig);
        rig = new_rig;
        model = new_model;
    }

    void noteScale(float scale)
    {
        const size_t enough = 16; // a stitcher has two
        scales.erase(std::remove(scales.begin(), scales.end(), scale), scales.end());
        scales.insert(scales.begin(), scale);
        scales.resize(std::min(scales.size(), enough));
    }
};

} // namespace gcpw
} // namespace cv

#endif
