// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#ifndef OPENCV_GCPW_FRAME_COMPOSER_HPP
#define OPENCV_GCPW_FRAME_COMPOSER_HPP

#include <memory>
#include <opencv2/stitching/warpers.hpp>
#include "opencv2/gcpw/rig.hpp"

namespace cv
{
namespace gcpw
{

//! @addtogroup gcpw
//! @{

/** @brief Panoramas of a rig's frames, one after another, at the cost of remapping them.

Maps, colours and cuts are made once, from the rig and its first frames. Then every frame is remapped, corrected and laid beside the
others. Cuts stay where they are and are feathered, not blended in bands: for video, in which a cut that moves would flicker.

@code
const cv::gcpw::Rig saved = cv::gcpw::Rig::load("rig.yml.gz");
const cv::gcpw::FrameComposer composer(saved, cv::makePtr<cv::SphericalWarper>(), photographs);
while (nextFrames(photographs)) // yours
    composer.compose(photographs, panorama);
@endcode

compose() may be called by several threads at once. */
class CV_EXPORTS_W FrameComposer
{
public:
    /** @brief Prepares maps, colours and cuts.
    @param rig usable()
    @param base creator of the warper that the rig was estimated with
    @param frames CV_8UC3, one for each image of the rig, in its order, for example the first ones. Of any size in the shape of the
    images that the rig was estimated from
    @param scale canvas pixels for each pixel of a frame, > 0
    @throws cv::Exception if the rig is not usable, counts, sizes or types do not fit, or the canvas would exceed 32766 px a side */
    FrameComposer(const Rig& rig, const Ptr<WarperCreator>& base, InputArrayOfArrays frames, double scale = 1);

    /** @overload
    @param rig one whose Rig::projection is known
    @param frames, scale as above
    @throws cv::Exception as above */
    CV_WRAP FrameComposer(const Rig& rig, InputArrayOfArrays frames, double scale = 1);

    /** @brief The panorama of some frames. The same bits for any number of threads.
    @param frames CV_8UC3, as many as the rig has images, each of the size of that given to the constructor
    @param panorama receives CV_8UC3 of size(); black where no frame has pixels
    @throws cv::Exception that names the frame if its size or type does not fit */
    CV_WRAP void compose(InputArrayOfArrays frames, OutputArray panorama) const;

    /// Of the panoramas.
    /// @return width and height, px
    CV_WRAP Size size() const;

private:
    struct Impl;
    std::shared_ptr<const Impl> impl_;
};

//! @}

} // namespace gcpw
} // namespace cv

#endif
