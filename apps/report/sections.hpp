// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#ifndef GCPW_APPS_REPORT_SECTIONS_HPP
#define GCPW_APPS_REPORT_SECTIONS_HPP

#include <string>
#include "report/viewer.hpp"

namespace report
{

// Parts of a page as HTML; empty where there is nothing to tell.

/// The figures that a reader looks at first, each with a sentence that says what it is.
std::string cards(const Page& page, const Misalignment& before, const Misalignment& after);

/// The photographs, as they were taken and as they are shown, and what the colour correction does to each.
std::string photographs(const Page& page);

/// What was found between each two photographs.
std::string pairs(const Page& page);

/// Levels and energies of the estimation.
std::string levels(const Page& page);

std::string timings(const Page& page);
std::string messages(const Page& page);

/// "3": the number of the photograph that is an image of the pictures, as a reader counts; "?" if it is none.
std::string numberOf(const Page& page, int image);

} // namespace report

#endif
