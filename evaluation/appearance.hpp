// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#ifndef GCPW_EVALUATION_APPEARANCE_HPP
#define GCPW_EVALUATION_APPEARANCE_HPP

#include <limits>
#include <vector>
#include "evaluation/bend.hpp"
#include "evaluation/row_file.hpp"
#include "evaluation/warped_image.hpp"

namespace evaluation
{

/// What a person sees and alignment scores do not. Lower is better, 0 cannot be seen; NaN where it was not measured.
struct Appearance
{
    double bend_p95 = std::numeric_limits<double>::quiet_NaN();   ///< see Bend, px
    double bend_share = std::numeric_limits<double>::quiet_NaN(); ///< see Bend, per cent
    double shape = std::numeric_limits<double>::quiet_NaN();      ///< Shape::stretch
    double seam_p95 = std::numeric_limits<double>::quiet_NaN();   ///< SeamVisibility::structure_p95
    double seam_worst = std::numeric_limits<double>::quiet_NaN(); ///< SeamVisibility::worst
    double cast = std::numeric_limits<double>::quiet_NaN();       ///< Tone::largestCast(), gray levels
    double crushed = std::numeric_limits<double>::quiet_NaN();    ///< see Tone, per cent
};

/// One of the measures: its column in a CSV file, its heading in a table, and how it is written there.
struct AppearanceColumn
{
    const char* name;
    const char* heading;
    const char* form;
    double Appearance::*value;
};

/// All of them, in the order in which tables have them.
const std::vector<AppearanceColumn>& appearanceColumns();

/// Adds a cell for each measure to a row; empty where it was not measured.
void appendCells(const Appearance& appearance, Cells& row);

/// Reads what appendCells() wrote, from the cell `first` on.
/// @throws cv::Exception that names the cell and its column if it is no number
Appearance readAppearance(const Cells& row, size_t first);

/// Of meshes: bend and shape.
void addMeshes(const cv::gcpw::Alignment& alignment, const std::vector<SegmentBend>& bends, Appearance& appearance);

/// Of what is shown: seams and tone.
void addPictures(const std::vector<WarpedImage>& images, Appearance& appearance);

} // namespace evaluation

#endif
