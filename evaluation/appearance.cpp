// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#include "evaluation/appearance.hpp"

#include <cmath>
#include <cstdlib>
#include "evaluation/seam_visibility.hpp"
#include "evaluation/shape.hpp"
#include "evaluation/tone.hpp"

namespace evaluation
{

const std::vector<AppearanceColumn>& appearanceColumns()
{
    static const std::vector<AppearanceColumn> columns = {
        {"bend_p95", "bend p95, px", "%.2f", &Appearance::bend_p95},
        {"bend_share", "bent, %", "%.1f", &Appearance::bend_share},
        {"shape", "shape", "%.3f", &Appearance::shape},
        {"seam_p95", "seam p95", "%.2f", &Appearance::seam_p95},
        {"seam_worst", "seam worst", "%.2f", &Appearance::seam_worst},
        {"cast", "cast", "%.1f", &Appearance::cast},
        {"crushed", "crushed, %", "%.2f", &Appearance::crushed},
    };
    return columns;
}

void appendCells(const Appearance& appearance, Cells& row)
{
    for (const AppearanceColumn& column : appearanceColumns())
    {
        const double value = appearance.*column.value;
        row.push_back(std::isfinite(value) ? cv::format("%.6f", value) : std::string());
    }
}

Appearance readAppearance(const Cells& row, size_t first)
{
    Appearance appearance;
    for (const AppearanceColumn& column : appearanceColumns())
    {
        const std::string& cell = row[first++];
        if (cell.empty())
            continue;
        char* end = nullptr;
        appearance.*column.value = std::strtod(cell.c_str(), &end);
        if (*end != '\0')
            CV_Error(cv::Error::StsParseError, "'" + cell + "' is no " + column.name + "; remove its row, or --fresh");
    }
    return appearance;
}

void addMeshes(const cv::gcpw::Alignment& alignment, const std::vector<SegmentBend>& bends, Appearance& appearance)
{
    const Bend bend = summary(bends);
    appearance.bend_p95 = bend.p95;
    appearance.bend_share = bend.share;
    appearance.shape = shapeOf(alignment).stretch;
}

void addPictures(const std::vector<WarpedImage>& images, Appearance& appearance)
{
    const SeamVisibility seams = seamVisibility(images);
    const Tone tone = toneOf(images);
    appearance.seam_p95 = seams.structure_p95;
    appearance.seam_worst = seams.worst;
    appearance.cast = tone.largestCast();
    appearance.crushed = tone.crushed;
}

} // namespace evaluation
