// Part of the GCPW module for OpenCV. Licence: Apache-2.0 (see LICENSE).
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
