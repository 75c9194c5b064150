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

/// Where an image lies at the moment: its mesh and its colour.
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
