// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#include "stitching/picture_scale.hpp"

#include <algorithm>
#include <cmath>

namespace cv
{
namespace gcpw
{

namespace
{

const double SLACK = 0.1; ///< of a picture's longer side: a bent mesh covers its picture less closely
const double SLACK_PX = 4; ///< of a small picture: its edges are whole pixels

/// Left, top, right, bottom of the canvas of scale 1 that an image covers.
Vec4d unitEdges(const RigModel& model, int index)
{
    const PlacedMesh placed = model.place(index, 1);
    Rect2d bounds = placed.mesh().bounds();
    if (model.items()[index].seam_rotation_rad != 0)
    {
        // An image across the seam is shown on the whole circle.
        bounds.x = -CV_PI;
        bounds.width = 2 * CV_PI;
    }
    return {bounds.x, bounds.y, bounds.x + bounds.width, bounds.y + bounds.height};
}

} // namespace

double pictureScale(const RigModel& model, int index, Rect picture, const std::vector<float>& made)
{
    const Vec4d unit = unitEdges(model, index);
    const Vec4d seen(picture.x - 0.5, picture.y - 0.5, picture.x + picture.width - 0.5, picture.y + picture.height - 0.5);
    const double fitted = seen.dot(unit) / unit.dot(unit); // least squares of scale * unit = seen
    const double slack = SLACK * std::max(picture.width, picture.height) + SLACK_PX;
    double best = 0;
    double least_deviation = slack;
    for (const float scale : made)
    {
        const double deviation = norm(unit * (scale - fitted), NORM_INF);
        if (deviation < least_deviation)
        {
            best = scale;
            least_deviation = deviation;
        }
    }
    if (best > 0)
        return best;
    for (const float scale : made)
        if (seen[0] >= unit[0] * scale - slack && seen[1] >= unit[1] * scale - slack && seen[2] <= unit[2] * scale + slack &&
            seen[3] <= unit[3] * scale + slack)
            return scale; // a part of a picture
    return fitted > 0 && std::isfinite(fitted) ? fitted : model.scale();
}

} // namespace gcpw
} // namespace cv
