// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#include "rendering/mesh_overlay.hpp"

#include <algorithm>
#include <opencv2/imgproc.hpp>

namespace cv
{
namespace gcpw
{

void drawMesh(const MeshGrid& mesh, const FrameScale& canvas, Point canvas_origin, Mat& picture)
{
    const Scalar color(80, 230, 120);
    const int fraction_bits = 4;
    const int thickness = std::max(1, cvRound(std::min(picture.cols, picture.rows) / 800.0));
    const auto place = [&](int col, int row)
    {
        const Point2d p = canvas.toFull(mesh.vertices()[row * (mesh.lattice().cols() + 1) + col]) - Point2d(canvas_origin);
        return Point(cvRound(p.x * (1 << fraction_bits)), cvRound(p.y * (1 << fraction_bits)));
    };
    for (int row = 0; row <= mesh.lattice().rows(); ++row)
        for (int col = 0; col <= mesh.lattice().cols(); ++col)
        {
            if (col > 0)
                line(picture, place(col - 1, row), place(col, row), color, thickness, LINE_AA, fraction_bits);
            if (row > 0)
                line(picture, place(col, row - 1), place(col, row), color, thickness, LINE_AA, fraction_bits);
        }
}

} // namespace gcpw
} // namespace cv
