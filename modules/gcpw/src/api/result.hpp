// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#ifndef OPENCV_GCPW_RESULT_HPP
#define OPENCV_GCPW_RESULT_HPP

#include "model/color_grid.hpp"
#include "rendering/inverse_map.hpp"
#include "opencv2/gcpw/alignment.hpp"
#include "optimization/coarse_to_fine.hpp"

namespace cv
{
namespace gcpw
{

/// Every image where the rough alignment has it, colours untouched.
std::vector<ImageState> roughStates(const Problem& problem);

/// Runs params.method and fills in everything of the report but the timings. `states` is the start and receives the result, or
/// the rough alignment where there is none.
void refine(const Problem& problem, const Params& params, const StepCallback& progress, std::vector<ImageState>& states,
            Report& report);

/// An image of an Alignment from its rough and its final state.
Alignment::Image toImage(const MeshGrid& rough, const ImageState& state, Size full_size);

/// The mesh of such an image: the inverse of toImage().
MeshGrid meshOf(const Alignment::Image& image);

/// Wall time since a getTickCount().
double millisecondsSince(int64 start);

} // namespace gcpw
} // namespace cv

#endif
