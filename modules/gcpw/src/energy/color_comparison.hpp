// Part of the GCPW module for OpenCV. Licence: Apache-2.0 (see LICENSE).
#ifndef OPENCV_GCPW_COLOR_COMPARISON_HPP
#define OPENCV_GCPW_COLOR_COMPARISON_HPP

#include <vector>
#include "energy/photometric_term.hpp"

namespace cv
{
namespace gcpw
{

/// The colours that two images show where they overlap, by pairs of quads.
struct ColorComparison
{
    int source_image = -1;
    int target_image = -1;
    std::vector<PhotometricTerm::QuadColors> quads;
};

/// One for each term, at the present meshes. Threads share the work.
std::vector<ColorComparison> compareColors(const std::vector<PhotometricTerm>& terms, const std::vector<ImageState>& states);

} // namespace gcpw
} // namespace cv

#endif
