// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
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

/** @brief What attach() returns: access to the alignment inside a cv::Stitcher. May be ignored or kept.

It does not keep the stitcher alive. */
class CV_EXPORTS_W StitcherBinding
{
public:
    virtual ~StitcherBinding() = default;

    /// The present rig.
    /// @return valid until the next estimation; its alignment's report says how it came about, or why the plain warper was used
    /// instead
    CV_WRAP virtual const Rig& rig() const = 0;

    /** @brief Sets a rig estimated before, by this or another process. Used as long as Rig::fits() the stitcher's cameras.
    @param rig with one that is not usable() its cameras get the plain warper; one that Rig::check() refuses is logged and taken
    for none */
    CV_WRAP virtual void setRig(const Rig& rig) = 0;

    /** @brief Sets images to estimate from where the stitcher detects no features: after Stitcher::setTransform() without a rig.
    @param images the photographs as given to the stitcher, one for each camera */
    CV_WRAP virtual void setImages(InputArrayOfArrays images) = 0;

    /// How often the alignment was estimated so far.
    /// @return 0 or more; does not rise while a rig is reused
    CV_WRAP virtual int estimations() const = 0;

    /** @brief Parts of the stitcher that were replaced after attach().
    @return "warper", "exposure compensator", "features finder", "features matcher", or some of them; empty if GCPW is attached as a
    whole, or the stitcher is gone */
    CV_WRAP virtual std::vector<std::string> replacedParts() const = 0;
};

/** @brief Replaces a stitcher's warper and exposure compensator by GCPW's; then use the stitcher as always.

@code
const cv::Ptr<cv::Stitcher> stitcher = cv::Stitcher::create(cv::Stitcher::PANORAMA);
const cv::Ptr<cv::gcpw::StitcherBinding> binding = cv::gcpw::attach(stitcher);
cv::Mat panorama;
stitcher->stitch(photographs, panorama);
binding->rig().save("rig.yml.gz"); // for other photographs by the same cameras: setRig()
@endcode

Five parts are replaced, each by one that contains the stitcher's own; attaching again unwraps them first:
- the warper, by GcpwWarper: the own one is the base warper;
- the exposure compensator, by GcpwCompensator: the own one is the fallback;
- the features finder, by one that keeps the images it is given and the keypoints it finds, if they are SIFT's; it finds the same;
- the features matcher, by one that starts from a fixed state of cv::theRNG() and restores the thread's state afterwards.
  OpenCV's matchers search random trees: this way the same images give the same bits every time;
- the seam finder, by GcpwSeamFinder, if it is a cv::detail::GraphCutSeamFinder, the stitcher's default. One that is set after
  attach() stays.

Call attach() last. If a part is replaced after it, a warning is logged and StitcherBinding::replacedParts() names the part;
without the warper or without any images the panorama is the plain one, and rig().alignment.report() says so.

The alignment is estimated once the cameras are known, from the images that the stitcher computed its features on
(registrationResol()), and kept until the cameras change: composePanorama() and setTransform() with the same cameras do not
estimate again. Whatever goes wrong in the refinement, the stitcher goes on with its own warper and compensator; the reason is
logged and in rig().alignment.report(). An estimate that was cancelled or short of memory is made again for the next panorama.

After setTransform() with unknown cameras the stitcher detects no features, so there are no images to estimate from: the plain
warper is used, unless StitcherBinding::setImages() or setRig() was called.
@param stitcher in PANORAMA or SCANS mode, set up completely. Without a features finder or matcher it can compose after
setTransform(), but stitch() and estimateTransform() throw cv::Exception
@param params of the alignment; referenceImage counts the images given to the stitcher, canvasPeriod is ignored
@return access to the alignment; need not be kept
@throws cv::Exception if the stitcher is empty, has no warper, or params are out of range */
CV_EXPORTS_W Ptr<StitcherBinding> attach(const Ptr<Stitcher>& stitcher, const Params& params = Params());

/** @overload
@param stitcher, params as above
@param progress called during the alignment; cancelling gives the plain panorama. What it throws passes through the stitcher,
which then estimates again for the next panorama
@return as above
@throws cv::Exception as above */
CV_EXPORTS_W Ptr<StitcherBinding> attach(const Ptr<Stitcher>& stitcher, const Params& params, const Progress& progress);

/// What a status of cv::Stitcher means, and what to do.
/// @param status any  @return one sentence without a full stop
CV_EXPORTS std::string explain(Stitcher::Status status);

//! @}

} // namespace gcpw
} // namespace cv

#endif
