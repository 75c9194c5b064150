// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#ifndef GCPW_APPS_REPORT_PAGE_FILES_HPP
#define GCPW_APPS_REPORT_PAGE_FILES_HPP

namespace report
{

/// The files of apps/report/page, which the build puts into the program.
namespace page_files
{
extern const char* const PAGE;
extern const char* const STYLE;
extern const char* const SCRIPT;
} // namespace page_files

} // namespace report

#endif
