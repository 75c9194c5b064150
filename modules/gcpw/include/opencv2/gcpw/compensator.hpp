// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
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

struct SharedState;

//! @addtogroup gcpw
//! @{

/** @brief Makes colours agree by a local affine map of each image: a gain and a bias of Y, Cr and Cb for every quad.

On its own, feed() estimates them from the means and contrasts of overlapping quads, without moving the images
(Params::balanceWeight); the mean light and hue of all images
stay unless Params::referenceImage names one that keeps its colours. With a rig (see
GcpwWarper::compensator) the colours of the alignment are used and feed() does nothing, also if it was called before there was
a rig. Gains given to setMatGains() take precedence over a rig's.

@code
cv::gcpw::GcpwCompensator compensator; // as any other cv::detail::ExposureCompensator
compensator.feed(corners, warped, masks); // std::vector<cv::UMat>, as a warper left them
for (size_t i = 0; i < warped.size(); ++i)
    compensator.apply(static_cast<int>(i), corners[i], warped[i], masks[i]);
@endcode */
class CV_EXPORTS_W GcpwCompensator : public cv::detail::ExposureCompensator
{
public:
    /** @brief A compensator without colours.
    @param params meshCols, meshRows, sampleStep, referenceImage, photometricWeight, colorSmoothnessWeight, colorRestWeight and
    balanceWeight are used
    @throws cv::Exception if params are out of range */
    CV_WRAP explicit GcpwCompensator(const Params& params = Params());

    using cv::detail::ExposureCompensator::feed;

    /** @brief Estimates colours, unless a rig has them or setUpdateGain(false) was called after an estimate of as many
    images.
    @param corners canvas position of the top-left pixel of each image
    @param images CV_8UC3 or CV_8UC1, as warped
    @param masks CV_8UC1 of the images' sizes, each with the value that means inside
    @throws cv::Exception if counts, types or sizes do not fit; the previous colours are kept */
    void feed(const std::vector<Point>& corners, const std::vector<UMat>& images,
              const std::vector<std::pair<UMat, uchar> >& masks) CV_OVERRIDE;

    /** @brief Corrects an image at any scale.
    @param index of the image; one without colours leaves the image as it is
    @param corner canvas position of its top-left pixel. Used with a rig only: corner and size then tell the scale of the warper
    that made the image, and the mesh which quad a pixel belongs to
    @param image CV_8UC3, CV_8UC1, or, unless the fallback is in use, CV_16UC3; corrected in place
    @param mask used by the fallback only
    @throws cv::Exception if the image is of another type */
    void apply(int index, Point corner, InputOutputArray image, InputArray mask) CV_OVERRIDE;

    /** @brief The colours in use.
    @param gains one Mat an image, meshRows x meshCols, CV_32FC(6): gain of Y, Cr, Cb, then bias of Y, Cr, Cb of each quad;
    intensities in [0, 1]. While the fallback is in use, its gains */
    void getMatGains(std::vector<Mat>& gains) CV_OVERRIDE;

    /** @brief Sets the colours to use.
    @param gains as from getMatGains(); of another type only while the fallback is in use, which then gets them
    @throws cv::Exception if a Mat is of another type, empty or not finite; nothing is changed then */
    void setMatGains(std::vector<Mat>& gains) CV_OVERRIDE;

    /** @brief Sets the compensator that feed() and apply() use while there is neither a rig nor gains of setMatGains().
    @param fallback may be empty: then feed() estimates the colours */
    CV_WRAP void setFallback(const Ptr<cv::detail::ExposureCompensator>& fallback) { fallback_ = fallback; }

    /// The compensator of setFallback().
    /// @return may be empty
    CV_WRAP Ptr<cv::detail::ExposureCompensator> fallback() const { return fallback_; }

private:
    friend struct PartFactory;
    GcpwCompensator(const Params& params, const std::shared_ptr<SharedState>& shared_state);

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
    std::shared_ptr<SharedState> shared_state_;
    Ptr<cv::detail::ExposureCompensator> fallback_;
    std::vector<Mat> colors_;
    bool given_; ///< by setMatGains()
};

//! @}

} // namespace gcpw
} // namespace cv

#endif
