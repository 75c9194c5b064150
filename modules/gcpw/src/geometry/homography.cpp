// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#include "geometry/homography.hpp"

#include <algorithm>
#include <cmath>

namespace cv
{
namespace gcpw
{

namespace
{

/// The similarity that brings points to mean 0 and mean distance sqrt(2).
Matx33d normaliser(const std::vector<Point2d>& points)
{
    Point2d mean;
    for (const Point2d& p : points)
        mean += p;
    mean *= 1.0 / static_cast<double>(points.size());
    double distance = 0;
    for (const Point2d& p : points)
        distance += norm(p - mean);
    distance /= static_cast<double>(points.size());
    const double s = distance > 0 ? std::sqrt(2.0) / distance : 1;
    return {s, 0, -s * mean.x, 0, s, -s * mean.y, 0, 0, 1};
}

void addRow(Matx<double, 9, 9>& normal, const Vec<double, 9>& row, double weight)
{
    for (int i = 0; i < 9; ++i)
        for (int j = 0; j < 9; ++j)
            normal(i, j) += weight * row[i] * row[j];
}

} // namespace

Point2d applyHomography(const Matx33d& h, Point2d p)
{
    const Vec3d q = h * Vec3d(p.x, p.y, 1);
    return {q[0] / q[2], q[1] / q[2]};
}

bool fitHomography(const std::vector<PointMatch>& points, const std::vector<LineMatch>& lines, Matx33d& b_from_a)
{
    if (2 * points.size() + 2 * lines.size() < 8)
        return false;
    std::vector<Point2d> all_a;
    std::vector<Point2d> all_b;
    for (const PointMatch& match : points)
    {
        all_a.push_back(match.a);
        all_b.push_back(match.b);
    }
    for (const LineMatch& match : lines)
    {
        all_a.insert(all_a.end(), {match.a.start, match.a.end});
        all_b.insert(all_b.end(), {match.b.start, match.b.end});
    }
    const Matx33d ta = normaliser(all_a);
    const Matx33d tb = normaliser(all_b);
    Matx<double, 9, 9> normal = Matx<double, 9, 9>::zeros();
    for (const PointMatch& match : points)
    {
        const Point2d a = applyHomography(ta, match.a);
        const Point2d b = applyHomography(tb, match.b);
        addRow(normal, {a.x, a.y, 1, 0, 0, 0, -b.x * a.x, -b.x * a.y, -b.x}, match.weight);
        addRow(normal, {0, 0, 0, a.x, a.y, 1, -b.y * a.x, -b.y * a.y, -b.y}, match.weight);
    }
    for (const LineMatch& match : lines)
    {
        const Segment b{applyHomography(tb, match.b.start), applyHomography(tb, match.b.end)};
        if (!(b.length() > 0))
            continue;
        const Line line = b.line();
        const double l[3] = {line.normal.x, line.normal.y, line.offset};
        for (const Point2d& end : {match.a.start, match.a.end})
        {
            const Point2d a = applyHomography(ta, end);
            Vec<double, 9> row;
            for (int k = 0; k < 3; ++k)
            {
                row[3 * k] = l[k] * a.x;
                row[3 * k + 1] = l[k] * a.y;
                row[3 * k + 2] = l[k];
            }
            addRow(normal, row, match.weight);
        }
    }
    Mat values;
    Mat vectors;
    if (!eigen(Mat(normal), values, vectors))
        return false;
    // The second smallest eigenvalue is zero too if the data leave more than one homography. Eigenvalues are the squares of
    // the rows' singular values, so this asks for a condition below 1e5, far above what normalised frames have.
    if (!(values.at<double>(7) > 1e-10 * values.at<double>(0)))
        return false;
    const Matx33d h(vectors.ptr<double>(8));
    b_from_a = tb.inv() * h * ta;
    if (!(std::abs(b_from_a(2, 2)) > 1e-12))
        return false;
    b_from_a *= 1 / b_from_a(2, 2);
    return true;
}

bool isPlausible(const Matx33d& h, Size image_size, double max_zoom)
{
    const double w = image_size.width - 1;
    const double l = image_size.height - 1;
    for (const Point2d& p : {Point2d(0, 0), Point2d(w, 0), Point2d(0, l), Point2d(w, l)})
    {
        const double z = h(2, 0) * p.x + h(2, 1) * p.y + h(2, 2);
        // det of the Jacobian of a homography is det(H) / z^3
        const double area = determinant(h) / (z * z * z);
        if (!(z > 0) || !(area > 0) || !(area <= max_zoom * max_zoom))
            return false;
        // Of both singular values of the Jacobian the product is the area, and the sum of squares that of its elements.
        const Point2d q = applyHomography(h, p);
        const Matx22d jacobian((h(0, 0) - q.x * h(2, 0)) / z, (h(0, 1) - q.x * h(2, 1)) / z, (h(1, 0) - q.y * h(2, 0)) / z,
                               (h(1, 1) - q.y * h(2, 1)) / z);
        const double squares = jacobian.dot(jacobian);
        const double largest = std::sqrt(0.5 * (squares + std::sqrt(std::max(squares * squares - 4 * area * area, 0.0))));
        if (!(area / largest >= 1 / max_zoom))
            return false;
    }
    return true;
}

} // namespace gcpw
} // namespace cv
