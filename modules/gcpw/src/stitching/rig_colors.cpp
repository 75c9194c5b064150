// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#include "stitching/rig_colors.hpp"

#include <cmath>

namespace cv
{
namespace gcpw
{

GridPosition positionOnColors(const RigModel& model, int index, double scale, Rect picture, Size grid)
{
    const RigModel::Item& item = model.items()[index];
    const PlacedMesh placed = model.place(index, scale);
    const double x_scale = static_cast<double>(grid.width) / item.image.work_size.width;
    const double y_scale = static_cast<double>(grid.height) / item.image.work_size.height;
    // Turned off the seam, the mesh lies on one side of it only.
    const double period = item.seam_rotation_rad == 0 ? 0 : 2 * CV_PI * scale;
    const Rect2d bounds = placed.mesh().bounds();
    const double middle = bounds.x + 0.5 * bounds.width;
    int hint = -1;
    return positionOnNodes(picture.size(),
                           [&](Point2d p)
                           {
        Point2d canvas = p + Point2d(picture.tl());
        if (period > 0)
            canvas.x -= period * std::round((canvas.x - middle) / period);
        const Point2d at = placed.latticePoint(placed.referenceAt(canvas, hint));
        return Point2d((at.x + 0.5) * x_scale, (at.y + 0.5) * y_scale);
    });
}

} // namespace gcpw
} // namespace cv
