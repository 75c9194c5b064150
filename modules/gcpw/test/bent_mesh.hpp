// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#ifndef OPENCV_GCPW_TEST_BENT_MESH_HPP
#define OPENCV_GCPW_TEST_BENT_MESH_HPP

#include "test_precomp.hpp"

#include <functional>
#include <vector>
#include "model/mesh_grid.hpp"
#include "seeded.hpp"

namespace opencv_test
{

/// The undeformed lattice with every vertex moved by up to `jitter_px` on each axis.
inline cv::gcpw::MeshGrid bentMesh(const cv::gcpw::Lattice& lattice, double jitter_px, uint64_t seed,
                                   Point2d origin = Point2d())
{
    cv::gcpw::MeshGrid mesh(lattice, origin);
    RNG rng = seeded(seed);
    for (Point2d& vertex : mesh.vertices())
        vertex += Point2d(rng.uniform(-jitter_px, jitter_px), rng.uniform(-jitter_px, jitter_px));
    return mesh;
}

/// Every vertex through an affine map: canvas = linear * vertex + shift.
inline cv::gcpw::MeshGrid affineMesh(const cv::gcpw::MeshGrid& mesh, const Matx22d& linear, Point2d shift)
{
    cv::gcpw::MeshGrid result = mesh;
    for (Point2d& vertex : result.vertices())
    {
        const Vec2d moved = linear * Vec2d(vertex.x, vertex.y);
        vertex = Point2d(moved[0], moved[1]) + shift;
    }
    return result;
}

/// Derivative of a function of meshes by every vertex coordinate (x0 y0 x1 ..) of one of them, by central differences.
inline std::vector<double>
finiteDifferences(const std::function<double(const std::vector<cv::gcpw::MeshGrid>&)>& function,
                  std::vector<cv::gcpw::MeshGrid> meshes, int image, double step_px = 1e-4)
{
    std::vector<double> derivative;
    for (size_t i = 0; i < meshes[image].vertices().size(); ++i)
        for (int axis = 0; axis < 2; ++axis)
        {
            double& coordinate = axis == 0 ? meshes[image].vertices()[i].x : meshes[image].vertices()[i].y;
            const double before = coordinate;
            coordinate = before + step_px;
            const double high = function(meshes);
            coordinate = before - step_px;
            const double low = function(meshes);
            coordinate = before;
            derivative.push_back((high - low) / (2 * step_px));
        }
    return derivative;
}

} // namespace opencv_test

#endif
