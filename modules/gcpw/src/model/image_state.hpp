// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#ifndef OPENCV_GCPW_IMAGE_STATE_HPP
#define OPENCV_GCPW_IMAGE_STATE_HPP

#include <vector>
#include "model/color_grid.hpp"
#include "model/mesh_grid.hpp"

namespace cv
{
namespace gcpw
{

/// The unknowns of one image: its mesh and its colours.
struct ImageState
{
    MeshGrid mesh;
    ColorGrid color;
};

/// All images of an alignment.
typedef std::vector<ImageState> State;

} // namespace gcpw
} // namespace cv

#endif
