// Part of the GCPW module for OpenCV. Licence: Apache-2.0 (see LICENSE).
#ifndef OPENCV_GCPW_STITCHER_HPP
#define OPENCV_GCPW_STITCHER_HPP

#include <string>
#include <vector>
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

    /** @brief Parts of the stitcher that were replaced after attach(): "warper", "exposure compensator", "features finder",
    "features matcher". Empty if GCPW is attached as a whole, or the stitcher is gone. */
    virtual std::vector<std::string> replacedParts() const = 0;
};

/** @brief Puts GCPW in the place of a stitcher's warper and exposure compensator; then use the stitcher as always.

Four parts are replaced, each by one that contains the stitcher's own; attaching again unwraps them first:
- the warper, by GcpwWarper: the own one is the base warper;
- the exposure compensator, by GcpwCompensator: the own one is the fallback;
- the features finder, by one that keeps the images and, of SIFT, the keypoints that pass by; it finds the same;
- the features matcher, by one that draws from a fixed state of cv::theRNG() and puts the thread's state back. OpenCV's
  matchers look for neighbours in random trees: so the same images give the same bits again, whatever was drawn before.

A part that is replaced after attach() is missed: a warning is logged, StitcherBinding::replacedParts() names it, and without
the warper or without any images the panorama is the plain one and rig().alignment.report() says so. Call attach() last.

The alignment is estimated once the cameras are known, from the images that the stitcher computed its features on
(registrationResol()), and kept until the cameras change: composePanorama() and setTransform() with the same cameras do not
estimate again. Whatever goes wrong in the refinement, the stitcher goes on with its own warper and compensator; the reason is
logged and in rig().alignment.report(). An estimate that was cancelled or short of memory is made again for the next panorama.

After setTransform() with unknown cameras the stitcher shows its images to nobody in time: the plain warper is used, unless
StitcherBinding::setImages() or setRig() was called.
@param stitcher in PANORAMA or SCANS mode, set up completely. Without a features finder or matcher it can compose after
setTransform(), but stitch() and estimateTransform() throw cv::Exception
@param params constants of the alignment; referenceImage counts the images given to the stitcher
@param progress called during the alignment; cancelling gives the plain panorama. What it throws passes through the stitcher,
which then estimates again for the next panorama
@throws cv::Exception if the stitcher is empty, has no warper, or params are out of range */
CV_EXPORTS Ptr<StitcherBinding> attach(const Ptr<Stitcher>& stitcher, const Params& params = Params(),
                                       const Progress& progress = Progress());

//! @}

} // namespace gcpw
} // namespace cv

#endif
