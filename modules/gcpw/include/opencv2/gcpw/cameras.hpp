// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#ifndef OPENCV_GCPW_CAMERAS_HPP
#define OPENCV_GCPW_CAMERAS_HPP

#include <string>
#include <vector>
#include <opencv2/stitching/detail/camera.hpp>
#include <opencv2/stitching/detail/matchers.hpp>
#include <opencv2/stitching/warpers.hpp>
#include "opencv2/gcpw/rig.hpp"

namespace cv
{
namespace gcpw
{

//! @addtogroup gcpw
//! @{

/// How estimateCameras() looks for cameras.
struct CV_EXPORTS_W_SIMPLE CameraOptions
{
    /// The defaults.
    CV_WRAP CameraOptions();

    /// Resolution of features and cameras, million pixels, more than 0: that of Stitcher::registrationResol(). Default 0.6.
    CV_PROP_RW double workMegapix;
    /// Confidence of matches that two photographs belong together, as Stitcher::panoConfidenceThresh(), more than 0. Default 1.
    CV_PROP_RW double confidence;
    /// Name of a warper as alignRigByName() knows them, to be used in any case; empty, the default, chooses.
    CV_PROP_RW std::string projection;
    /// Focal length of each photograph, pixels of the photograph as given, as its file notes it (EXIF); 0 where it is not known. Empty,
    /// the default: of none. Where matches alone do not fix the focal lengths, the search starts from these once more; what comes of it
    /// is taken only if it shows matched points clearly nearer to each other.
    CV_PROP_RW std::vector<double> focal;
    CV_PROP_RW Ptr<Feature2D> finder;                    //!< empty: SIFT, also where contrast is low
    CV_PROP_RW Ptr<cv::detail::FeaturesMatcher> matcher; //!< empty: best of two nearest
    /// Tried on photographs that the first leaves alone; its matches count only if the pictures confirm them. Empty: as the first,
    /// less strict.
    CV_PROP_RW Ptr<cv::detail::FeaturesMatcher> secondMatcher;
};

/** @brief Cameras and a projection for a set of photographs, and why these. */
struct CV_EXPORTS_W_SIMPLE CameraEstimate
{
    /// Without cameras: not ok().
    CV_WRAP CameraEstimate() : work_scale(1), turned(false) {}

    CV_PROP_RW std::vector<int> component;                    //!< which of the photographs have a camera, 0-based, ascending
    CV_PROP_RW std::vector<cv::detail::CameraParams> cameras; //!< of these, at the resolution of `images`; none if there are none
    CV_PROP_RW std::vector<Mat> images;                       //!< these photographs, 8-bit as given, scaled down by work_scale
    std::vector<KnownKeypoints> keypoints;         //!< of `images`; empty if they are not SIFT's
    CV_PROP_RW double work_scale;                             //!< pixels of `images` per pixel of the photographs
    CV_PROP_RW std::string projection;                        //!< name of the warper that the cameras are for
    /// The picture comes out turned to the left: rotate(picture, picture, ROTATE_90_CLOCKWISE) makes it stand. So are sweeps
    /// upwards and photographs that lie on their side kept off the poles of the sphere.
    CV_PROP_RW bool turned;
    CV_PROP_RW std::vector<std::string>
        decisions; //!< one sentence for each choice that was made, in order; the reason if there are no cameras

    /// Whether there are cameras.
    /// @return false if no two photographs match; the last of `decisions` says why
    CV_WRAP bool ok() const { return !cameras.empty(); }

    /// The warper of `projection`.
    /// @return its creator, e.g. cv::SphericalWarper
    Ptr<WarperCreator> warper() const;
};

/** @brief Finds cameras and a projection that make a picture of sound proportions out of as many photographs as possible.

Where cv::Stitcher's estimation ends in cameras that ask for an absurd picture, or leaves photographs out, others are tried in a fixed
order, and the first are taken that a picture can be made of:
- a link of two photographs that matches alone do not make sure is confirmed, or not, by correlating what both show;
- cameras that turn, each with its own focal length; the same, starting from CameraOptions::focal; with one focal length for all and a
  robust loss; photographs of a plane;
- the plane, the sphere along the strip or column of the photographs, or the stereographic projection, by how much they stretch.

Each choice is logged and told in CameraEstimate::decisions. The same photographs give the same cameras every time.

@code
const cv::gcpw::CameraEstimate estimate = cv::gcpw::estimateCameras(photographs);
const cv::Ptr<cv::Stitcher> stitcher = cv::Stitcher::create();
stitcher->setWarper(estimate.warper());
const cv::Ptr<cv::gcpw::StitcherBinding> binding = cv::gcpw::attach(stitcher);
binding->setRig(cv::gcpw::alignRig(estimate));
stitcher->setTransform(photographs, estimate.cameras, estimate.component);
stitcher->composePanorama(picture);
@endcode

@param photographs two or more, 8-bit BGR, BGRA or gray
@param options see there
@param progress of the stages "features" and "cameras"; may be empty. Cancelling returns an estimate without cameras
@return the cameras, or none and the reason in CameraEstimate::decisions
@throws cv::Exception if photographs are too few, empty or not of 8 bits, or options are out of range; and what `progress` throws */
CV_EXPORTS_W CameraEstimate estimateCameras(InputArrayOfArrays photographs,
                                            const CameraOptions& options = CameraOptions(),
                                            const Progress& progress = Progress());

/** @brief The median focal length of cameras: the scale that cv::Stitcher gives to its warper, WarperCreator::create().
@param cameras one or more
@return pixels of the images that the cameras refer to; of an even number the mean of the two in the middle
@throws cv::Exception if there are none */
CV_EXPORTS_W float medianFocal(const std::vector<cv::detail::CameraParams>& cameras);

/** @brief alignRig() of such cameras, with the keypoints that are known already: alignEstimate in Python.
@param estimate that is ok()
@param params, progress as for alignRig(); params.referenceImage counts the photographs given to estimateCameras()
@return with component and work_scale, so that it fits a cv::Stitcher after setTransform()
@throws cv::Exception also if the estimate has no cameras */
CV_EXPORTS_AS(alignEstimate) Rig alignRig(const CameraEstimate& estimate, const Params& params = Params(),
                                          const Progress& progress = Progress());

//! @}

} // namespace gcpw
} // namespace cv

#endif
