// Part of the GCPW module for OpenCV. Licence: Apache-2.0 (see LICENSE).
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

Its canvas is that of a base warper (spherical, plane, ..) at `scale`; meshes are rendered at any other scale. */
struct CV_EXPORTS Rig
{
    Alignment alignment; //!< image k belongs to camera k; no images if nothing could be estimated (see its report)
    std::vector<cv::detail::CameraParams> cameras; //!< at the resolution of the estimation; R is CV_32F
    std::vector<Size> image_sizes;                 //!< pixels of each camera's image at that resolution
    std::vector<int> component;                    //!< which of the user's images they are, 0-based; may be empty
    std::vector<double> turns; //!< radians by which an image was turned about the vertical axis, off the panorama's seam
    float scale = 0;           //!< of the base warper that made the canvas
    double work_scale = 1;     //!< px of the estimation per px of the photographs as given

    /// Whether there is a refinement to render: status OK and one mesh for each camera.
    bool usable() const;

    /** @brief Refuses a rig that says it is refined but cannot be rendered; one without a refinement always passes.

    Called by whatever takes a rig. With status OK and images: as many cameras as images, each with an R of 3 x 3 finite values,
    a finite focal length and aspect > 0 and a finite principal point; `image_sizes`, `component` and `turns` each empty or
    one for each image: sizes of 1 px or more, indices from 0 on and none twice, turns of at most one circle; finite scales > 0.
    @throws cv::Exception that names the member and its value */
    void check() const;

    /// Whether these are the very cameras of the rig: intrinsics and rotations equal bit for bit (R as CV_32F).
    bool fits(const std::vector<cv::detail::CameraParams>& others) const;

    /** @brief Writes everything to a file: .yml, .xml or .json, with .gz compressed. Numbers are kept exactly.
    @throws cv::Exception StsError if not all of it can be written; a file that was there before is kept then */
    void save(const std::string& path) const;

    /** @throws cv::Exception StsError if there is no such file, StsParseError if it is not a rig; both name the file */
    static Rig load(const std::string& path);
};

/** @brief Estimates a rig from photographs and their cameras.

Warps every image with the base warper at the cameras' median focal length, as cv::Stitcher does, and refines with Aligner.
@param images 8-bit, one for each camera and of the resolution the cameras refer to
@param cameras as cv::detail::BundleAdjusterBase leaves them; for the affine warper R is the affine map
@param base creator of the base warper
@param keypoints of the images, see Aligner::align()
@return a rig that is not usable(), with a report that says why, where data, cameras or regions of interest gave no answer
@throws cv::Exception if counts do not fit or params are out of range */
CV_EXPORTS Rig alignRig(InputArrayOfArrays images, const std::vector<cv::detail::CameraParams>& cameras,
                        const Ptr<WarperCreator>& base, const Params& params = Params(),
                        const Progress& progress = Progress(),
                        const std::vector<KnownKeypoints>& keypoints = std::vector<KnownKeypoints>());

//! @}

} // namespace gcpw
} // namespace cv

#endif
