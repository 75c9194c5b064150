// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#ifndef OPENCV_GCPW_COLOR_PRIORS_HPP
#define OPENCV_GCPW_COLOR_PRIORS_HPP

#include <vector>
#include "energy/color_prior_term.hpp"
#include "overlap/color_comparison.hpp"

namespace cv
{
namespace gcpw
{

/// A weight and a reference for each image.
struct ImagePriors
{
    std::vector<double> weights;
    std::vector<ColorGrid::Quad> references;
};

/** @brief The priors of all quads of all images.
@param compared of the quads that are compared with another image  @param alone of the others */
std::vector<ColorPriors> colorPriors(const std::vector<ColorComparison>& comparisons, const std::vector<Lattice>& lattices,
                                     const ImagePriors& compared, const ImagePriors& alone);

} // namespace gcpw
} // namespace cv

#endif
