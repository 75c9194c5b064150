// Part of the GCPW module for OpenCV. Licence: Apache-2.0 (see LICENSE).
#ifndef OPENCV_GCPW_SESSION_HPP
#define OPENCV_GCPW_SESSION_HPP

#include <functional>
#include <memory>
#include "adapters/rig_model.hpp"

namespace cv
{
namespace gcpw
{

/// What a warper's creator, the compensator and the stitcher's binding know together.
struct Session
{
    Ptr<WarperCreator> base;
    Rig rig;
    std::shared_ptr<const RigModel> model; ///< of the rig; empty if it is not usable
    float scale = 0;                       ///< of the warper created last
    std::function<void()> before_create;   ///< the binding's chance to estimate; may be empty

    void setRig(const Rig& new_rig)
    {
        model = RigModel::create(new_rig); // refuses a bad one before anything changes
        rig = new_rig;
    }
};

} // namespace gcpw
} // namespace cv

#endif
