// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#ifndef GCPW_APPS_REPORT_REPORT_HPP
#define GCPW_APPS_REPORT_REPORT_HPP

#include <functional>
#include <string>
#include "common/output_plan.hpp"
#include "report/page.hpp"

namespace report
{

/// Adds what --report=path writes to a plan: a folder with a page, unless the name ends in .json or is a device.
void addTo(OutputPlan& plan, const std::string& path);

/** @brief Writes a report: a folder with index.html and report.json, or the JSON file alone.
@param path as --report has it, not empty  @param json the text  @param page called if there is to be a page */
void write(const std::string& path, const std::string& json, const std::function<Page()>& page);

} // namespace report

#endif
