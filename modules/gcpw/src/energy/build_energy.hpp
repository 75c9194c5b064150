// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#ifndef OPENCV_GCPW_BUILD_ENERGY_HPP
#define OPENCV_GCPW_BUILD_ENERGY_HPP

#include <vector>
#include "energy/color_prior_term.hpp"
#include "energy/energy.hpp"
#include "energy/problem.hpp"
#include "opencv2/gcpw/params.hpp"
#include "overlap/overlap_samples.hpp"

namespace cv
{
namespace gcpw
{

/// Quads of the source of an overlap that are kept near where another mesh has them.
struct AnchoredQuads
{
    MeshGrid mesh;
    std::vector<int> cells; ///< may be empty
};

/// What the terms of one stage of the optimisation are built from; must outlive them.
struct EnergyStage
{
    double match_scale = 0;                ///< Geman-McClure scale of the matches, canvas px; 0 is the plain sum of squares
    double scale = 1;                      ///< working pixels per pixel of the level
    std::vector<OverlapSamples> overlaps;  ///< one for each pair of the problem; none while matches are alone
    std::vector<ColorPriors> color_priors; ///< one for each image, or none
    std::vector<AnchoredQuads> anchors;    ///< one for each overlap, or none
};

/// Which kinds of energy a method has.
bool hasPoints(Method method);
bool hasLines(Method method);
bool hasPixels(Method method);
bool hasColors(Method method);

/** @brief The terms of a method on one stage: a method *is* this list (eq. totalfunction).

A new term is a line here. */
Energy buildEnergy(const Problem& problem, const Params& params, const EnergyStage& stage);

} // namespace gcpw
} // namespace cv

#endif
