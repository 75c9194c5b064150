// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#include "cameras/straighten.hpp"

#include <algorithm>
#include <cmath>

namespace cv
{
namespace gcpw
{

namespace
{

const double SPOT_RAD = 0.08; ///< turns below about 5 degrees do not say what they turn about
const double LONGER = 1.5;    ///< a column is that much longer than wide: of a square grid the rows are kept level

Vec3d column(const Matx33d& R, int k)
{
    return {R(0, k), R(1, k), R(2, k)};
}

/// Eigenvalues, falling, and eigenvectors (rows) of the mean of v v^T over one axis of all cameras.
void spreadOf(const std::vector<Matx33d>& rotations, int axis, Vec3d& values, Matx33d& vectors)
{
    Matx33d moment = Matx33d::zeros();
    for (const Matx33d& R : rotations)
        moment += column(R, axis) * column(R, axis).t();
    moment *= 1.0 / static_cast<double>(rotations.size());
    Mat found;
    Mat rows;
    eigen(Mat(moment), found, rows);
    values = Vec3d(found.at<double>(0), found.at<double>(1), found.at<double>(2));
    vectors = Matx33d(rows.ptr<double>());
}

/// How far the cameras turned about the axis that their axis k is perpendicular to, rad (standard deviation).
double turnSeenBy(const std::vector<Matx33d>& rotations, int axis)
{
    Vec3d values;
    Matx33d vectors;
    spreadOf(rotations, axis, values, vectors);
    return std::sqrt(std::max(0.0, values[1]));
}

Matx33d rowsOf(const Vec3d& x, const Vec3d& y, const Vec3d& z)
{
    return {x[0], x[1], x[2], y[0], y[1], y[2], z[0], z[1], z[2]};
}

/// The view in the middle of the list, where views all around have no mean.
Vec3d meanView(const std::vector<Matx33d>& rotations)
{
    Vec3d sum(0, 0, 0);
    for (const Matx33d& R : rotations)
        sum += column(R, 2);
    return norm(sum) > 0.05 * static_cast<double>(rotations.size()) ? sum : column(rotations[rotations.size() / 2], 2);
}

/// World with `down` as its y axis and the mean view ahead.
Matx33d upright(const std::vector<Matx33d>& rotations, const Vec3d& down)
{
    Vec3d ahead = meanView(rotations);
    ahead -= down * down.dot(ahead);
    if (norm(ahead) < 1e-6)
        ahead = column(rotations[0], 2).cross(down).cross(down);
    if (norm(ahead) < 1e-6)
        ahead = column(rotations[0], 0).cross(down);
    ahead = normalize(ahead);
    return rowsOf(down.cross(ahead), down, ahead);
}

} // namespace

SetShape shapeOf(const std::vector<Matx33d>& rotations)
{
    // Cameras that turn about their y axis move their x axis, and the other way round; a roll moves both alike.
    const double along_x = turnSeenBy(rotations, 0);
    const double along_y = turnSeenBy(rotations, 1);
    if (std::max(along_x, along_y) < SPOT_RAD)
        return SetShape::SPOT;
    return along_y > LONGER * along_x ? SetShape::COLUMN : SetShape::STRIP;
}

Matx33d straightening(const std::vector<Matx33d>& rotations, SetShape shape)
{
    if (shape == SetShape::SPOT)
        return centring(rotations);
    const int axis = shape == SetShape::STRIP ? 0 : 1;
    Vec3d values;
    Matx33d vectors;
    spreadOf(rotations, axis, values, vectors);
    Vec3d down(vectors(2, 0), vectors(2, 1), vectors(2, 2));
    // The cameras' own y axis points down; in a column that lies on its side their x axis does, against its sign.
    double agreement = 0;
    for (const Matx33d& R : rotations)
        agreement += shape == SetShape::STRIP ? down.dot(column(R, 1)) : -down.dot(column(R, 0));
    return upright(rotations, agreement < 0 ? -down : down);
}

Matx33d centring(const std::vector<Matx33d>& rotations)
{
    const Vec3d ahead = normalize(meanView(rotations));
    Vec3d down(0, 0, 0);
    for (const Matx33d& R : rotations)
        down += column(R, 1);
    down -= ahead * ahead.dot(down);
    if (norm(down) < 1e-6)
        down = column(rotations[0], 1) - ahead * ahead.dot(column(rotations[0], 1));
    if (norm(down) < 1e-6)
        down = column(rotations[0], 0) - ahead * ahead.dot(column(rotations[0], 0));
    down = normalize(down);
    return rowsOf(down.cross(ahead), down, ahead);
}

} // namespace gcpw
} // namespace cv
