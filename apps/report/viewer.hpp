// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#ifndef GCPW_APPS_REPORT_VIEWER_HPP
#define GCPW_APPS_REPORT_VIEWER_HPP

#include "report/maps.hpp"
#include "report/page.hpp"

namespace report
{

/// Both pictures of a page as its viewer shows them, and the figures found on the way.
struct Viewer
{
    std::string html;
    Misalignment before;
    Misalignment after;
};

/// One picture over the other behind a slider, with layers: mesh, cuts, straight lines, misalignment, plain mean, change of light.
/// @param page with a picture
Viewer viewerOf(const Page& page);

/// Of the places that a reader looks at first, both pictures enlarged: where the cut of either breaks the strongest edges.
std::string closeUps(const Page& page);

} // namespace report

#endif
