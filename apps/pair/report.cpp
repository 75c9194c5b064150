// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#include "pair/report.hpp"

#include "common/json.hpp"

using namespace cv::gcpw;

namespace
{

void addEnergies(Json& json, const std::string& key, const std::vector<TermEnergy>& energies)
{
    json.beginObject(key);
    for (const TermEnergy& energy : energies)
        json.add(energy.name, energy.value);
    json.add("total", totalEnergy(energies));
    json.endObject();
}

void addScore(Json& json, const std::string& key, const Score& score)
{
    json.beginObject(key).add("ncc", score.ncc).add("zncc", score.zncc).endObject();
}

} // namespace

std::string reportText(const Report& report, const std::string& method, const Score* before, const Score* after,
                       double render_ms)
{
    Json json;
    json.beginObject();
    json.add("status", toString(report.status)).add("message", report.message).add("method", method);
    json.add("points", report.pairs.empty() ? 0 : report.pairs[0].points);
    json.add("lines", report.pairs.empty() ? 0 : report.pairs[0].lines);
    json.add("folds", report.folds).add("max_displacement_px", report.max_displacement_px);
    json.add("gain_min", report.gain_min).add("gain_max", report.gain_max);
    json.beginArray("levels");
    for (const LevelReport& level : report.levels)
    {
        json.beginObject().add("scale", level.scale).add("iterations", level.iterations);
        json.add("stop", toString(level.stop));
        addEnergies(json, "energy_start", level.start);
        addEnergies(json, "energy_end", level.end);
        json.endObject();
    }
    json.endArray();
    if (before && after)
    {
        json.beginObject("scores");
        addScore(json, "before", *before);
        addScore(json, "after", *after);
        json.endObject();
    }
    const Timings& t = report.timings_ms;
    json.beginObject("timings_ms").add("features", t.features).add("homography", t.homography).add("align", t.align);
    json.add("render", render_ms).add("total", t.total + render_ms).endObject();
    json.endObject();
    return json.text();
}
