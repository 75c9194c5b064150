// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#ifndef OPENCV_GCPW_PROBLEM_HPP
#define OPENCV_GCPW_PROBLEM_HPP

#include <vector>
#include "geometry/curve.hpp"
#include "geometry/matches.hpp"
#include "imaging/pyramid.hpp"
#include "model/mesh_grid.hpp"

namespace cv
{
namespace gcpw
{

/// One image of the alignment, at the working resolution.
struct ProblemImage
{
    MeshGrid rough;                    ///< the rough alignment: where the lattice lies on the canvas before refinement
    std::vector<PyramidLevel> pyramid; ///< may be empty if no method with pixels is used
    std::vector<Curve> straight;       ///< reference px: what is straight in the scene and is to stay so
    std::vector<double> outside;       ///< of every quad: how far it lies from any overlap, reference px; may be empty
    bool fixed = false;                ///< neither mesh nor colour changes
};

/// Two images that overlap, and what was matched between them.
struct ProblemPair
{
    int a = -1; ///< its pixels are the samples
    int b = -1;
    Point2d shift_b; ///< canvas px by which b is seen beside its own place: a multiple of a wrapping canvas' width
    MatchSet matches;
};

/// Everything the optimiser needs to know.
struct Problem
{
    std::vector<ProblemImage> images;
    std::vector<ProblemPair> pairs;
    int color_reference = -1; ///< image whose colours are shown as they are; -1: none, those of all are balanced

    /// Three images or more: errors may add up from image to image, so shape and contrast need priors.
    bool hasManyImages() const { return images.size() > 2; }
};

} // namespace gcpw
} // namespace cv

#endif
