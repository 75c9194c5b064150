// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#ifndef OPENCV_GCPW_PERF_CANVAS_VIEWS_HPP
#define OPENCV_GCPW_PERF_CANVAS_VIEWS_HPP

#include "perf_precomp.hpp"

#include <vector>

namespace opencv_test
{

/** @brief Views of one canvas side by side, as Aligner takes them, with keypoints as a stitcher finds them.

Each view has a smooth displacement of its own, as parallax makes it, and an exposure of its own.
Neighbours share 37 % of their width. */
struct CanvasViews
{
    std::vector<Point> corners;
    std::vector<Mat> images;
    std::vector<gcpw::KnownKeypoints> keypoints;
    int period = 0; ///< px after which the canvas repeats; 0: it does not

    /// @param closed whether the last view meets the first
    CanvasViews(int count, bool closed);
};

} // namespace opencv_test

#endif
