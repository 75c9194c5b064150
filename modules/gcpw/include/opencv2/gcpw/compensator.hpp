// Part of the GCPW module for OpenCV. Licence: Apache-2.0 (see LICENSE).
#ifndef OPENCV_GCPW_COMPENSATOR_HPP
#define OPENCV_GCPW_COMPENSATOR_HPP

#include <memory>
#include <vector>
#include <opencv2/stitching/detail/exposure_compensate.hpp>
#include "opencv2/gcpw/params.hpp"

namespace cv
{
namespace gcpw
{

struct Session;

//! @addtogroup gcpw
//! @{

/** @brief Makes colours agree with a local affine map on every quad of each image.

On its own, feed() estimates colours by the means and contrasts of overlapping quads while the images stand still
(Params::balanceWeight); no image is privileged unless Params::referenceImage names one. With a rig (see
GcpwWarper::compensator) the colours of the joint alignment are used and feed() does nothing: also where it was called before
the rig was there. Only gains of setMatGains() come before a rig's. */
class CV_EXPORTS GcpwCompensator : public cv::detail::ExposureCompensator
{
public:
    explicit GcpwCompensator(const Params& params = Params());

    using cv::detail::ExposureCompensator::feed;

    /** @brief Estimates colours, unless a rig has them or setUpdateGain(false) was called after an estimate of as many
    images.
    @param corners top-left pixels  @param images CV_8UC3 or CV_8UC1, as warped  @param masks CV_8UC1, with the value that
    means inside
    @throws cv::Exception if counts, types or sizes do not fit; the colours of before stay */
    void feed(const std::vector<Point>& corners, const std::vector<UMat>& images,
              const std::vector<std::pair<UMat, uchar> >& masks) CV_OVERRIDE;

    /** @brief Corrects an image at any scale; an index without colours is left alone.
    @param corner of the image on the canvas; used with a rig, whose meshes say what a pixel shows: corner and size tell the
    scale of the warper, whatever warpers were made since
    @param image CV_8UC3 or CV_8UC1 */
    void apply(int index, Point corner, InputOutputArray image, InputArray mask) CV_OVERRIDE;

    /// One rows x cols, CV_32FC(6) per image: gain Y, Cr, Cb, bias Y, Cr, Cb; intensities in [0, 1]. While the fallback is in
    /// use, what it has.
    void getMatGains(std::vector<Mat>& gains) CV_OVERRIDE;

    /// Of the same type; while the fallback is in use, all other types go to it.
    /// @throws cv::Exception if a Mat is not of that type, empty or not finite; nothing is changed then
    void setMatGains(std::vector<Mat>& gains) CV_OVERRIDE;

    /// Used by feed() and apply() where neither a rig nor colours of its own are at hand.
    void setFallback(const Ptr<cv::detail::ExposureCompensator>& fallback) { fallback_ = fallback; }
    Ptr<cv::detail::ExposureCompensator> fallback() const { return fallback_; }

    /// Shared by the warper, the compensator and the stitcher's binding.
    GcpwCompensator(const Params& params, const std::shared_ptr<Session>& session);

private:
    /// Whose colours are shown.
    enum class Source
    {
        RIG,
        OWN,
        FALLBACK
    };

    bool hasRig() const;
    Source source() const;

    Params params_;
    std::shared_ptr<Session> session_;
    Ptr<cv::detail::ExposureCompensator> fallback_;
    std::vector<Mat> colors_;
    bool given_; ///< by setMatGains()
};

//! @}

} // namespace gcpw
} // namespace cv

#endif
