// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#ifndef OPENCV_GCPW_ALIGNER_HPP
#define OPENCV_GCPW_ALIGNER_HPP

#include "opencv2/gcpw/alignment.hpp"

namespace cv
{
namespace gcpw
{

//! @addtogroup gcpw
//! @{

/// Matches of two of the images given to Aligner::align(), in pixels of each of them.
struct CV_EXPORTS Correspondences
{
    int a = 0; //!< index of the one image, 0-based
    int b = 1; //!< index of the other, not a
    std::vector<Point2f> points_a; //!< pixels of image a as given, finite
    std::vector<Point2f> points_b; //!< the match of each of points_a in image b; wrong ones are found and left out
};

/// SIFT keypoints of one image that are known already, to save finding them again.
struct CV_EXPORTS KnownKeypoints
{
    std::vector<Point2f> points; //!< pixels of the image as given
    Mat descriptors;             //!< points.size() x 128, CV_32F or CV_8U, as cv::SIFT computes them
};

/// What is straight in the scene, as one image shows it. See Params::straightnessWeight.
struct CV_EXPORTS KnownLines
{
    /// Each the image of one straight edge: two points or more in order, finite, pixels of the image as given. Bent where the
    /// warp onto the canvas has bent it.
    std::vector<std::vector<Point2f>> curves;
    /// The borders of the photograph, in the same form. They are held only where no other image shows them: there they are borders of
    /// the picture, too.
    std::vector<std::vector<Point2f>> borders;
};

/** @brief Refines roughly aligned images on a canvas: meshes and colours of all of them in one problem.

Every pair that overlaps adds its terms, so loops close and the order of the images does not matter. The reference image
(Params::referenceImage) keeps its place. It keeps its colours too if it is named; else the
panorama keeps the mean light and hue of its photographs (Params::balanceWeight). Thread-safe: align() changes nothing in the object.

@code
// corners, images, masks: as warped by any cv::detail::RotationWarper
const cv::Ptr<cv::gcpw::Aligner> aligner = cv::gcpw::Aligner::create();
const cv::gcpw::Alignment alignment = aligner->align(corners, images, masks);
@endcode */
class CV_EXPORTS_W Aligner
{
public:
    virtual ~Aligner();

    /** @brief Makes an aligner.
    @param params kept as a copy
    @return the aligner, never empty
    @throws cv::Exception if params are out of range */
    CV_WRAP static Ptr<Aligner> create(const Params& params = Params());

    /** @brief Aligns images that a rough alignment has already warped onto one canvas.

    The first three arguments are those of cv::detail::ExposureCompensator::feed.
    @param corners canvas position of the top-left pixel of each image; moving all of them by the same vector moves the result by it
    @param images two or more, CV_8UC3 (BGR), CV_8UC1 or CV_8UC4, each at least 1 x 1 px
    @param masks CV_8UC1 of the same sizes, non-zero inside; an empty vector means everywhere
    @param correspondences matches known already; if there are any, no others are looked for, also not for other pairs
    @param progress may be empty; cancelling returns the rough alignment with Status::CANCELLED
    @param keypoints one entry for each image, or none; where an entry is empty, they are found here
    @param lines one entry for each image, or none: then line segments are looked for in the images as they are, which finds long
    lines in pieces where a warp has bent them, and images without a mask end at their borders
    @return one image for each of those given; where the refinement failed, undeformed meshes and a status other than OK
    @throws cv::Exception before any work, if counts, sizes or types do not fit, a value is not finite, the canvas would exceed
    2^20 px a side or Params::canvasPeriod is narrower than an image */
    virtual Alignment align(const std::vector<Point>& corners, InputArrayOfArrays images, InputArrayOfArrays masks,
                            const std::vector<Correspondences>& correspondences, const Progress& progress = Progress(),
                            const std::vector<KnownKeypoints>& keypoints = std::vector<KnownKeypoints>(),
                            const std::vector<KnownLines>& lines = std::vector<KnownLines>()) = 0;

    /** @overload
    @param corners canvas position of the top-left pixel of each image
    @param images two or more, 8-bit BGR, gray or BGRA
    @param masks CV_8UC1 of the same sizes, non-zero inside; an empty vector means everywhere
    @return as above, with nothing known beforehand
    @throws cv::Exception as above */
    CV_WRAP Alignment align(const std::vector<Point>& corners, InputArrayOfArrays images, InputArrayOfArrays masks);

    /// What create() was given.
    /// @return the aligner's own copy, valid as long as the aligner
    CV_WRAP virtual const Params& params() const = 0;
};

//! @}

} // namespace gcpw
} // namespace cv

#endif
