// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#ifndef OPENCV_GCPW_TEST_CAMERA_TURN_HPP
#define OPENCV_GCPW_TEST_CAMERA_TURN_HPP

#include "test_precomp.hpp"

#include <cmath>
#include "geometry/homography.hpp"
#include "model/mesh_grid.hpp"

namespace opencv_test
{

/// Of a camera that turned to the right between source and target. Its focal length is the photograph's width (53 degrees).
inline Matx33d targetFromSource(Size photo, double degrees)
{
    const double f = photo.width;
    const Matx33d camera(f, 0, 0.5 * (photo.width - 1), 0, f, 0.5 * (photo.height - 1), 0, 0, 1);
    const double c = std::cos(degrees * CV_PI / 180);
    const double s = std::sin(degrees * CV_PI / 180);
    const Matx33d turn(c, 0, -s, 0, 1, 0, s, 0, c);
    const Matx33d h = camera * turn * camera.inv();
    return h * (1 / h(2, 2));
}

/// A mesh whose vertices a homography places.
inline cv::gcpw::MeshGrid warpedLattice(const cv::gcpw::Lattice& lattice, const Matx33d& canvas_from_photo)
{
    cv::gcpw::MeshGrid mesh(lattice);
    for (Point2d& vertex : mesh.vertices())
        vertex = cv::gcpw::applyHomography(canvas_from_photo, vertex);
    return mesh;
}

} // namespace opencv_test

#endif
