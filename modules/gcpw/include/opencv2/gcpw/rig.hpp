// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#ifndef OPENCV_GCPW_RIG_HPP
#define OPENCV_GCPW_RIG_HPP

#include <string>
#include <vector>
#include <opencv2/stitching/detail/camera.hpp>
#include <opencv2/stitching/warpers.hpp>
#include "opencv2/gcpw/aligner.hpp"

namespace cv
{
namespace gcpw
{

//! @addtogroup gcpw
//! @{

/** @brief An alignment together with the cameras it was estimated for: one estimate, many frames.

Its canvas is that of a base warper (spherical, plane, ..) at `scale`; meshes are rendered at any other scale.

@code
const cv::gcpw::Rig rig = cv::gcpw::alignRig(images, cameras, cv::makePtr<cv::SphericalWarper>());
if (rig.usable())
    rig.save("rig.yml.gz");
@endcode */
struct CV_EXPORTS_W_SIMPLE Rig
{
    /// Without cameras: not usable().
    CV_WRAP Rig() : scale(0), work_scale(1), turned(false) {}

    CV_PROP_RW Alignment alignment; //!< image k belongs to camera k; no images if nothing could be estimated (see its report)
    CV_PROP_RW std::vector<cv::detail::CameraParams> cameras; //!< at the resolution of the estimation; R is CV_32F
    CV_PROP_RW std::vector<Size> image_sizes; //!< pixels of each camera's image at that resolution
    CV_PROP_RW std::vector<int> component;    //!< which of the user's images they are, 0-based; may be empty
    /// Radians by which an image was turned about the vertical axis, to keep it off the panorama's seam: 0 for most, -2 pi..2 pi.
    CV_PROP_RW std::vector<double> turns;
    CV_PROP_RW float scale;       //!< of the base warper that made the canvas: canvas pixels per radian, > 0 if usable
    CV_PROP_RW double work_scale; //!< pixels of the estimation per pixel of the photographs as given, > 0
    CV_PROP_RW String projection; //!< name of the base warper, as alignRigByName() knows them; empty if it is not known
    CV_PROP_RW bool turned;       //!< the picture comes out turned to the left by 90 degrees, see CameraEstimate

    /** @brief Whether there is a refinement to render: status OK, meshes, and nothing that check() refuses.

    Whatever takes a rig (GcpwWarper, GcpwRotationWarper, StitcherBinding) goes on without one that is not usable, and logs what is
    wrong where check() would throw.
    @return whether meshes and colours of this rig would be shown */
    CV_WRAP bool usable() const;

    /** @brief Refuses a rig that says it is refined but cannot be rendered; one without a refinement always passes.

    Called by load(). With status OK and images: as many cameras as images, each with an R of 3 x 3 finite values,
    a finite focal length and aspect > 0 and a finite principal point; `image_sizes`, `component` and `turns` each empty or
    one for each image: sizes of 1 px or more, indices from 0 on and none twice, turns of at most one circle; finite scales > 0;
    meshes of at most 2^20 px a side, within 10^9 px of the origin.
    @throws cv::Exception that names the member and its value */
    CV_WRAP void check() const;

    /** @brief Whether these are the cameras of the rig: intrinsics and rotations equal bit for bit (R as CV_32F).
    @param others cameras at the resolution of the rig's
    @return false also if they are more or fewer */
    CV_WRAP bool fits(const std::vector<cv::detail::CameraParams>& others) const;

    /** @brief Writes everything to a file. Numbers are kept exactly.
    @param path ending in .yml, .xml or .json; with .gz behind it compressed
    @throws cv::Exception StsError if not all of it can be written; a file that was there before is kept then */
    CV_WRAP void save(const std::string& path) const;

    /** @brief Reads what save() wrote.

    Damaged files are refused, also where OpenCV's parser would crash, and compressed ones (.gz) of more than 256 MB of text.
    @param path of the file
    @return equal to what was saved
    @throws cv::Exception StsError if there is no such file, StsParseError if it is not a rig; both name the file */
    CV_WRAP static Rig load(const std::string& path);
};

/** @brief Estimates a rig from photographs and their cameras.

Warps every image with the base warper at the cameras' median focal length, as cv::Stitcher does, and refines with Aligner.
@param images two or more, 8-bit BGR, gray or BGRA, one for each camera and at the resolution that the cameras refer to
@param cameras as cv::detail::BundleAdjusterBase leaves them; for the affine warper R is the affine map
@param base creator of the base warper, e.g. cv::SphericalWarper
@param params of the alignment; canvasPeriod is ignored, workMegapix may be exceeded twice
@param progress may be empty; cancelling returns a rig that is not usable()
@param keypoints of the images, see Aligner::align()
@return a rig that is not usable(), with a report that says why, if nothing could be estimated from these images and cameras
@throws cv::Exception if counts do not fit or params are out of range */
CV_EXPORTS Rig alignRig(InputArrayOfArrays images, const std::vector<cv::detail::CameraParams>& cameras,
                        const Ptr<WarperCreator>& base, const Params& params = Params(),
                        const Progress& progress = Progress(),
                        const std::vector<KnownKeypoints>& keypoints = std::vector<KnownKeypoints>());

/** @brief alignRig() with a base warper by its name, for languages without cv::WarperCreator: alignRig in Python.
@param images, cameras as above
@param params, progress as above
@param warper a name that cv::PyRotationWarper knows: "plane", "affine", "cylindrical", "spherical", "fisheye", "stereographic",
"compressedPlaneA2B1", "compressedPlaneA1.5B1", "compressedPlanePortraitA2B1", "compressedPlanePortraitA1.5B1", "paniniA2B1",
"paniniA1.5B1", "paniniPortraitA2B1", "paniniPortraitA1.5B1", "mercator" or "transverseMercator"
@return as above, with the name of its projection
@throws cv::Exception also StsBadArg if there is no warper of that name */
CV_EXPORTS_AS(alignRig) Rig alignRigByName(InputArrayOfArrays images, const std::vector<cv::detail::CameraParams>& cameras,
                                           const String& warper, const Params& params = Params(),
                                           const Progress& progress = Progress());

//! @}

} // namespace gcpw
} // namespace cv

#endif
