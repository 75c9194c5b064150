// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#ifndef OPENCV_GCPW_SEAM_FINDER_HPP
#define OPENCV_GCPW_SEAM_FINDER_HPP

#include <memory>
#include <opencv2/stitching/detail/seam_finders.hpp>

namespace cv
{
namespace gcpw
{

//! @addtogroup gcpw
//! @{

struct SharedState;

/** @brief Cuts between photographs where they agree all around, not only at the cut.

A graph cut as cv::detail::GraphCutSeamFinder's, with another cost: squared differences of light, hue and gradient, averaged over a
Gaussian of 2 px. A thing that two photographs show in different places is left to one of them as a whole,
where a cut over single pixels finds those that agree by chance and leaves halves. Where things are found again at another place of the
other photograph, a cut between both places costs extra: it would show them twice, or not at all. It takes the place of any SeamFinder; attach() puts
it in the place of cv::Stitcher's default. */
class CV_EXPORTS GcpwSeamFinder : public cv::detail::PairwiseSeamFinder
{
public:
    /// For a loop of one's own, or Stitcher::setSeamFinder().
    GcpwSeamFinder();

    /** @brief Splits what images share, pair by pair.
    @param src CV_32FC3, as cv::Stitcher gives them, or CV_8UC3; BGR in 0..255
    @param corners canvas position of each, px
    @param masks CV_8UC1, 255 inside; afterwards no pixel that two images share is in both
    @throws cv::Exception if the lists differ in length, or images are not of the type named */
    void find(const std::vector<UMat>& src, const std::vector<Point>& corners, std::vector<UMat>& masks) override;

    /// The finder that is used while there is no rig: what the stitcher had before attach().
    /// @return may be empty
    Ptr<cv::detail::SeamFinder> fallback() const { return fallback_; }

protected:
    /// Splits what two of the images given to find() share.
    /// @param first, second numbers of the images
    /// @param roi part of the canvas in both; found anew
    void findInPair(size_t first, size_t second, Rect roi) override;

private:
    friend struct PartFactory;
    GcpwSeamFinder(const std::shared_ptr<SharedState>& shared_state, const Ptr<cv::detail::SeamFinder>& fallback);

    std::shared_ptr<SharedState> shared_state_;
    Ptr<cv::detail::SeamFinder> fallback_;
};

//! @}

} // namespace gcpw
} // namespace cv

#endif
