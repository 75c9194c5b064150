// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#include "report/report.hpp"

#include "common/paths.hpp"
#include "common/write_file.hpp"

namespace report
{

namespace
{

bool isPage(const std::string& path)
{
    return endingOf(path) != ".json" && !isDevice(path);
}

} // namespace

void addTo(OutputPlan& plan, const std::string& path)
{
    if (isPage(path))
        plan.writesFolder("--report", path);
    else
        plan.writesFile("--report", path);
}

void write(const std::string& path, const std::string& json, const std::function<Page()>& page)
{
    if (!isPage(path))
        return writeText(path, json);
    const std::string html = htmlOf(page());
    makeFolder(path);
    writeText(path + "/index.html", html);
    writeText(path + "/report.json", json);
}

} // namespace report
