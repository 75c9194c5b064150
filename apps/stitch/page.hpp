// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#ifndef GCPW_APPS_STITCH_PAGE_HPP
#define GCPW_APPS_STITCH_PAGE_HPP

#include "report/page.hpp"
#include "report/recorded_seams.hpp"
#include "stitch/compose.hpp"
#include "stitch/report.hpp"

/// Sets the seam finder of a layout to one that keeps its cuts.
cv::Ptr<report::RecordedSeams> recordSeams(Layout& layout);

/** @brief The page of --report.

Composes the photographs a second time by OpenCV alone, with the same cameras, to compare with.
@param composition the picture; without one if the layout is not ok
@param seams of the composition; null if it was stitched as a pair */
report::Page pageOf(const StitchJob& job, const std::vector<Photograph>& photographs, const Layout& layout,
                    const Composition& composition, const cv::Ptr<report::RecordedSeams>& seams, const Stages& stages);

#endif
