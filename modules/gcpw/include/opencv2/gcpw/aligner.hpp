// Part of the GCPW module for OpenCV. Licence: Apache-2.0 (see LICENSE).
#ifndef OPENCV_GCPW_ALIGNER_HPP
#define OPENCV_GCPW_ALIGNER_HPP

#include "opencv2/gcpw/alignment.hpp"

namespace cv
{
namespace gcpw
{

//! @addtogroup gcpw
//! @{

/// Points that two of the images given to Aligner::align() have in common, in the pixels of each of them.
struct CV_EXPORTS Correspondences
{
    int a = 0; //!< index of the one image
    int b = 1; //!< index of the other, not a
    std::vector<Point2f> points_a; //!< finite, as all points here
    std::vector<Point2f> points_b; //!< as many as points_a; wrong ones are found and left out
};

/// SIFT keypoints of one image that were found already, to save finding them again.
struct CV_EXPORTS KnownKeypoints
{
    std::vector<Point2f> points; //!< px of the image as given
    Mat descriptors;             //!< points.size() x 128, CV_32F or CV_8U, as cv::SIFT computes them
};

/** @brief Refines roughly aligned images on a canvas: meshes and colours of all of them in one problem.

Every pair that overlaps ties its two images, so loops close and no image is privileged by its order. The reference
image (Params::referenceImage) keeps its place. Of two images it keeps its colours too; of more only if it is named, else
colours are changed by mean gain 1 and mean bias 0 (Params::balanceWeight). */
class CV_EXPORTS Aligner : public Algorithm
{
public:
    /// @throws cv::Exception if params are out of range
    static Ptr<Aligner> create(const Params& params = Params());

    /** @brief Aligns images that a rough alignment has already warped onto one canvas.

    The first three arguments are those of cv::detail::ExposureCompensator::feed.
    @param corners canvas position of the top-left pixel of each image; moving all of them moves the result and no more
    @param images 8-bit BGR, gray or BGRA
    @param masks CV_8UC1 of the same sizes, non-zero inside; an empty vector means everywhere
    @param correspondences matches known already; where none are given for any pair, they are found here
    @param progress may be empty; cancelling returns the rough alignment with Status::CANCELLED
    @param keypoints one entry for each image, or none; where an entry is empty, they are found here
    @return meshes at rest with a status other than OK where the refinement had no answer
    @throws cv::Exception before any work, if counts, sizes or types do not fit, a value is not finite, the canvas would exceed
    2^20 px a side or Params::canvasPeriod is narrower than an image */
    virtual Alignment align(const std::vector<Point>& corners, InputArrayOfArrays images, InputArrayOfArrays masks,
                            const std::vector<Correspondences>& correspondences = std::vector<Correspondences>(),
                            const Progress& progress = Progress(),
                            const std::vector<KnownKeypoints>& keypoints = std::vector<KnownKeypoints>()) = 0;

    virtual const Params& params() const = 0;
};

//! @}

} // namespace gcpw
} // namespace cv

#endif
