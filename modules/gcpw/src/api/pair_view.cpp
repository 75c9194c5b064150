// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#include "api/pair_view.hpp"

#include <algorithm>
#include <cmath>
#include <opencv2/stitching/warpers.hpp>
#include "cameras/projection_choice.hpp"
#include "cameras/rotation_fit.hpp"
#include "rendering/natural_view.hpp"

namespace cv
{
namespace gcpw
{

namespace
{

const double WORK_AREA = 5e5; ///< px of the larger photograph, for which the losses of the fit are made
/// Of the longer side, of a turning camera. Steps to the side look like turns at twice that.
const double MAX_MISS = 0.005;
/// Straight lines are worth more than less. It also keeps pictures of a plane flat: steps along it look like a turn.
const double LITTLE_STRETCH = 1.25;
const int LEAST_POINTS = 12; ///< in the overlap
const float CERTAIN = 100;   ///< confidence of a link that is an alignment

/// Middles of the quads that lie on the target, scaled.
Link linkOf(const MeshGrid& mesh, Size source, Size target, double scale)
{
    Link link;
    link.a = 0;
    link.b = 1;
    link.confidence = CERTAIN;
    const Lattice& lattice = mesh.lattice();
    const Rect2d inside(-0.5, -0.5, target.width, target.height);
    for (int cell = 0; cell < lattice.cellCount(); ++cell)
    {
        CellPoint middle;
        middle.cell = cell;
        middle.weight = bilinearWeights(0.5, 0.5);
        const Point2d on_target = mesh.warp(middle);
        if (!inside.contains(on_target))
            continue;
        const Point2d of_source((cell % lattice.cols() + 0.5) * source.width / lattice.cols(),
                                (cell / lattice.cols() + 0.5) * source.height / lattice.rows());
        link.points_a.push_back(of_source * scale);
        link.points_b.push_back(on_target * scale);
    }
    return link;
}

cv::detail::CameraParams cameraOf(double focal, Size size, const Matx33d& rotation)
{
    cv::detail::CameraParams camera;
    camera.focal = focal;
    camera.ppx = 0.5 * size.width;
    camera.ppy = 0.5 * size.height;
    camera.R = Mat(Matx33f(rotation));
    return camera;
}

Ptr<cv::detail::RotationWarper> warperOf(const std::string& name, float scale)
{
    if (name == "plane")
        return PlaneWarper().create(scale);
    return name == "spherical" ? SphericalWarper().create(scale) : StereographicWarper().create(scale);
}

/// @return false where no turning camera explains the pair, or nothing says where up is
bool viewOfTurn(const MeshGrid& source_mesh, Size source, Size target, CanvasView& view)
{
    const double scale = std::min(1.0, std::sqrt(WORK_AREA / std::max(source.area(), target.area())));
    const std::vector<Size> sizes = {Size(cvRound(source.width * scale), cvRound(source.height * scale)),
                                     Size(cvRound(target.width * scale), cvRound(target.height * scale))};
    const Link link = linkOf(source_mesh, source, target, scale);
    TurningCameras fit;
    if (static_cast<int>(link.points_a.size()) < LEAST_POINTS || !fitTurningCameras(sizes, {link}, fit))
        return false;
    const double side = std::max({sizes[0].width, sizes[0].height, sizes[1].width, sizes[1].height});
    if (!(std::sqrt(fit.cost) <= MAX_MISS * side))
        return false;
    const std::vector<cv::detail::CameraParams> cameras = {cameraOf(fit.focal, sizes[0], fit.rotations[0]),
                                                           cameraOf(fit.focal, sizes[1], fit.rotations[1])};
    const ProjectionChoice choice = chooseProjection(cameras, sizes, warperOf);
    if (choice.set_shape != SetShape::STRIP || !choice.picture.fault.empty() || choice.turned)
        return false;
    const double focal = fit.focal / scale;
    const Matx33d offset(1, 0, -0.5 * target.width, 0, 1, -0.5 * target.height, 0, 0, focal);
    const Matx33d ray_from_canvas = choice.world * fit.rotations[1] * offset;
    if (choice.name == "plane")
        view = CanvasView(Matx33d::diag(Vec3d(focal, focal, 1)) * ray_from_canvas);
    else if (choice.name == "spherical")
        view = CanvasView::onSphere(ray_from_canvas, focal);
    else
        return false;
    return true;
}

} // namespace

CanvasView pairView(const MeshGrid& source_mesh, Size source, Size target)
{
    const Lattice& quads = source_mesh.lattice();
    const std::vector<PlacedPhotograph> photographs = {{source_mesh, source},
                                                       {MeshGrid(Lattice(target, quads.cols(), quads.rows())), target}};
    const Matx33d flat = naturalView(photographs);
    CanvasView turned;
    const bool enough = largestStretch(flat, photographs) <= LITTLE_STRETCH;
    return !enough && viewOfTurn(source_mesh, source, target, turned) ? turned : CanvasView(flat);
}

} // namespace gcpw
} // namespace cv
