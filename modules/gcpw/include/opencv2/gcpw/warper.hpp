// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#ifndef OPENCV_GCPW_WARPER_HPP
#define OPENCV_GCPW_WARPER_HPP

#include <memory>
#include "opencv2/gcpw/rotation_warper.hpp"

namespace cv
{
namespace gcpw
{

class GcpwCompensator;
struct SharedState;

//! @addtogroup gcpw
//! @{

/** @brief Puts the meshes of a rig behind any warper.

For loops of one's own over cv::detail, as OpenCV's sample stitching_detailed; attach() does it for a cv::Stitcher.

@code
const cv::Ptr<cv::WarperCreator> base = cv::makePtr<cv::SphericalWarper>();
const cv::gcpw::GcpwWarper creator(base, cv::gcpw::alignRig(images, cameras, base));
const cv::Ptr<cv::detail::RotationWarper> warper = creator.create(scale); // then as any other
const cv::Ptr<cv::gcpw::GcpwCompensator> compensator = creator.compensator();
@endcode */
class CV_EXPORTS GcpwWarper : public WarperCreator
{
public:
    /** @brief A creator of warpers with the meshes of a rig.
    @param base creator of the base warper: the one that the rig was estimated with
    @param rig one that is not usable() leaves the base warper; one that Rig::check() refuses is logged
    @throws cv::Exception StsNullPtr if there is no base */
    explicit GcpwWarper(const Ptr<WarperCreator>& base, const Rig& rig = Rig());

    /** @brief A GcpwRotationWarper with the rig of this moment.
    @param scale of the base warper, > 0; need not be the scale of the rig
    @return never empty
    @throws cv::Exception if the base creator makes no warper */
    Ptr<cv::detail::RotationWarper> create(float scale) const CV_OVERRIDE;

    /// The present rig.
    /// @return valid until the next setRig()
    const Rig& rig() const;

    /** @brief Replaces the rig, for warpers made from now on and for compensators made already.
    @param rig one that is not usable() leaves the base warper; one that Rig::check() refuses is logged */
    void setRig(const Rig& rig);

    /// Creator of the base warper.
    /// @return the one given to the constructor, never empty
    Ptr<WarperCreator> base() const;

    /** @brief A compensator with the rig's colours, at the scale of whichever warper made the picture.
    @param params for GcpwCompensator::feed() while the rig is not usable()
    @return never empty; follows setRig()
    @throws cv::Exception if params are out of range */
    Ptr<GcpwCompensator> compensator(const Params& params = Params()) const;

private:
    friend struct PartFactory;
    explicit GcpwWarper(const std::shared_ptr<SharedState>& shared_state);

    std::shared_ptr<SharedState> shared_state_;
};

//! @}

} // namespace gcpw
} // namespace cv

#endif
