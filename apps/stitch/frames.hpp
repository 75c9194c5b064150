// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#ifndef GCPW_APPS_STITCH_FRAMES_HPP
#define GCPW_APPS_STITCH_FRAMES_HPP

#include <opencv2/stitching/detail/timelapsers.hpp>
#include "stitch/compose.hpp"

/** @brief Writes the warped photographs of a finished composition, with their colours untouched and corrected, and their masks.
@param folder made where it is missing: 000_image.png, 000_corrected.png, 000_mask.png, .., corners.csv */
void dumpWarped(const StitchJob& job, const std::vector<Photograph>& photographs, const Layout& layout);

/// The frames of a time lapse: each warped photograph by itself, all of one size.
class TimeLapse
{
public:
    TimeLapse(const StitchJob& job, const Layout& layout) : job_(job), layout_(layout) {}

    /// Writes the frame of the k-th photograph of the layout.
    void write(size_t k, const Warping& warping, const Warping::Warped& warped);

private:
    const StitchJob& job_;
    const Layout& layout_;
    cv::Ptr<cv::detail::Timelapser> timelapser_;
};

#endif
