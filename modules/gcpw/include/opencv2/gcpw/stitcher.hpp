// Part of the GCPW module for OpenCV. Licence: Apache-2.0 (see LICENSE).
#ifndef OPENCV_GCPW_STITCHER_HPP
#define OPENCV_GCPW_STITCHER_HPP

#include <opencv2/stitching.hpp>
#include "opencv2/gcpw/compensator.hpp"
#include "opencv2/gcpw/warper.hpp"

namespace cv
{
namespace gcpw
{

//! @addtogroup gcpw
//! @{

/** @brief What attach() returns: a look at the estimation inside a cv::Stitcher. May be ignored or kept.

It does not keep the stitcher alive. */
class CV_EXPORTS StitcherBinding
{
public:
    virtual ~StitcherBinding() = default;

    /// The present rig; its alignment's report says how it came about, or why the plain warper was used instead.
    virtual const Rig& rig() const = 0;

    /** @brief A rig estimated before, by this or another process. Used as long as the stitcher's cameras are those of the rig.
    @throws cv::Exception see Rig::check(); the old rig is kept then */
    virtual void setRig(const Rig& rig) = 0;

    /** @brief Images to estimate from where the stitcher sees none: after Stitcher::setTransform() without a rig.
    @param images the photographs as given to the stitcher, one for each camera */
    virtual void setImages(InputArrayOfArrays images) = 0;

    /// How often the alignment was estimated so far; does not rise while a rig is reused.
    virtual int estimations() const = 0;
};

/** @brief Puts GCPW in the place of a stitcher's warper and exposure compensator; then use the stitcher as always.

The stitcher's own warper becomes the base warper, its compensator the fallback. The alignment is estimated once the cameras
are known, from the images that the stitcher computed its features on (registrationResol()), and kept until the cameras
change: composePanorama() and setTransform() with the same cameras do not estimate again. Whatever goes wrong in the
refinement, the stitcher goes on with its own warper and compensator; the reason is logged and in rig().alignment.report().

After setTransform() with unknown cameras the stitcher shows its images to nobody in time: the plain warper is used, unless
StitcherBinding::setImages() or setRig() was called.
@param stitcher in PANORAMA or SCANS mode, set up completely; replaces its warper, exposure compensator and features finder
@param params constants of the alignment; referenceImage counts the images given to the stitcher
@param progress called during the alignment; cancelling gives the plain panorama
@throws cv::Exception if the stitcher is empty or params are out of range */
CV_EXPORTS Ptr<StitcherBinding> attach(const Ptr<Stitcher>& stitcher, const Params& params = Params(),
                                       const Progress& progress = Progress());

//! @}

} // namespace gcpw
} // namespace cv

#endif
