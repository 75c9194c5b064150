// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#include "stitch/report.hpp"

#include <algorithm>
#include "common/json.hpp"

using namespace cv::gcpw;

namespace
{

void addAlignment(Json& json, const Report& report, int estimations)
{
    json.beginObject("alignment").add("status", toString(report.status)).add("message", report.message);
    json.add("estimations", estimations).add("folds", report.folds);
    json.add("max_displacement_px", report.max_displacement_px);
    json.add("gain_min", report.gain_min).add("gain_max", report.gain_max);
    json.beginArray("pairs");
    for (const PairReport& pair : report.pairs)
    {
        json.beginObject().add("a", pair.a).add("b", pair.b).add("points", pair.points).add("lines", pair.lines);
        json.add("miss_before", pair.miss_before).add("miss_after", pair.miss_after).endObject();
    }
    json.endArray();
    const Timings& t = report.timings_ms;
    json.beginObject("timings_ms").add("features", t.features).add("matching", t.homography).add("align", t.align);
    json.add("total", t.total).endObject().endObject();
}

} // namespace

std::string reportText(const StitchJob& job, const std::vector<std::string>& paths, const Layout& layout,
                       const Stages& stages, cv::Size size)
{
    Json json;
    json.beginObject()
        .add("status", layout.ok() ? "stitched" : layout.trouble)
        .add("method", job.gcpw ? "gcpw" : "none");
    json.add("width", size.width).add("height", size.height).add("images", static_cast<int>(paths.size()));
    json.beginArray("dropped");
    for (size_t i = 0; i < paths.size(); ++i)
        if (std::find(layout.component.begin(), layout.component.end(), static_cast<int>(i)) == layout.component.end())
            json.add("", paths[i]);
    json.endArray();
    json.beginArray("decisions");
    for (const std::string& decision : layout.decisions)
        json.add("", decision);
    json.endArray();
    if (job.gcpw)
        addAlignment(json, layout.rig.alignment.report(), layout.estimations);
    json.beginObject("timings_ms")
        .add("read", stages.read)
        .add("cameras", stages.cameras)
        .add("compose", stages.compose);
    json.add("total", stages.total()).endObject().endObject();
    return json.text();
}
