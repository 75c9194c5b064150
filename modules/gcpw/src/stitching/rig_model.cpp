// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#include "stitching/rig_model.hpp"

#include <algorithm>
#include <opencv2/core/utils/logger.hpp>
#include "api/result.hpp"
#include "stitching/rig_fault.hpp"

namespace cv
{
namespace gcpw
{

PlacedMesh::PlacedMesh(const Alignment::Image& image, Size2d canvas_scale, double ratio) : mesh_(meshOf(image))
{
    // Estimation canvas of a working canvas point: (work + 0.5) / canvas_scale - 0.5.
    const auto place = [&](Point2d work)
    {
        return Point2d(((work.x + 0.5) / canvas_scale.width - 0.5) * ratio, ((work.y + 0.5) / canvas_scale.height - 0.5) * ratio);
    };
    const Vec2d rough = image.rough.at<Vec2d>(0, 0);
    const Point2d origin = Point2d(rough[0], rough[1]) - mesh_.lattice().referenceVertex(0);
    for (Point2d& vertex : mesh_.vertices())
        vertex = place(vertex);
    step_ = Point2d(ratio / canvas_scale.width, ratio / canvas_scale.height);
    start_ = place(origin);
}

Point2d PlacedMesh::referencePoint(Point2d lattice_px) const
{
    return {start_.x + lattice_px.x * step_.x, start_.y + lattice_px.y * step_.y};
}

Point2d PlacedMesh::latticePoint(Point2d reference_canvas_px) const
{
    return {(reference_canvas_px.x - start_.x) / step_.x, (reference_canvas_px.y - start_.y) / step_.y};
}

Point2d PlacedMesh::canvasAt(Point2d reference_canvas_px) const
{
    const Point2d at = latticePoint(reference_canvas_px);
    const Size size = mesh_.lattice().imageSize();
    const Point2d inside(std::min(std::max(at.x, -0.5), size.width - 0.5), std::min(std::max(at.y, -0.5), size.height - 0.5));
    return mesh_.warp(inside) + reference_canvas_px - referencePoint(inside);
}

Point2d PlacedMesh::referenceAt(Point2d canvas_px, int& hint) const
{
    CellPoint point;
    if (mesh_.invert(canvas_px, hint, point))
        return referencePoint(mesh_.lattice().referencePoint(point));
    // Outside the mesh: the map is close to a shift, so that this iteration contracts.
    Point2d reference = canvas_px;
    const int max_steps = 50;
    const double close_px = 1e-4;
    for (int i = 0; i < max_steps; ++i)
    {
        const Point2d error = canvas_px - canvasAt(reference);
        reference += error;
        if (error.dot(error) < close_px * close_px)
            break;
    }
    return reference;
}

std::shared_ptr<const RigModel> RigModel::create(const Rig& rig)
{
    const RigFault fault = findFault(rig);
    if (!fault.message.empty())
        CV_LOG_WARNING(nullptr, fault.message << "; the base warper is used");
    if (!rig.usable())
        return {};
    auto model = std::make_shared<RigModel>();
    model->scale_ = rig.scale;
    model->canvas_scale_ = rig.alignment.canvasScale();
    for (int i = 0; i < rig.alignment.imageCount(); ++i)
    {
        Item item;
        item.image = rig.alignment.image(i);
        Mat R;
        rig.cameras[i].R.convertTo(R, CV_32F);
        item.R = Matx33f(R.ptr<float>());
        item.seam_rotation_rad = rig.turns.empty() ? 0 : rig.turns[i];
        item.isIdentity = norm(item.image.mesh, item.image.rough, NORM_INF) == 0;
        model->items_.push_back(item);
    }
    return model;
}

std::vector<int> RigModel::find(const Matx33f& R) const
{
    std::vector<int> found;
    for (size_t i = 0; i < items_.size(); ++i)
        if (items_[i].R == R)
            found.push_back(static_cast<int>(i));
    return found;
}

} // namespace gcpw
} // namespace cv
