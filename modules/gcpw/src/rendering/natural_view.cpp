// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#include "rendering/natural_view.hpp"

#include <cmath>
#include "geometry/homography.hpp"

namespace cv
{
namespace gcpw
{

namespace
{

/// What is looked at of a quad.
struct Patch
{
    Point2d centre;   ///< canvas px
    Matx22d jacobian; ///< canvas px per pixel of the photograph
};

typedef std::vector<Patch> Patches;

/// Two numbers of stretch without change of area, two of perspective: a homography less its similarity.
const int UNKNOWNS = 4;
typedef Matx<double, UNKNOWNS, 1> Unknowns;

const int MAX_ITERATIONS = 50;  ///< fewer than 12 on all pairs seen
const int MAX_HALVINGS = 12;    ///< of a step
const double DIFFERENCE = 1e-4; ///< of an unknown, for the derivatives; unknowns are of the order of 1
const double STOP = 1e-7;       ///< of a step: far below a pixel over any photograph
/// Least depth of a vertex, that of the centre of all being 1: where it is 0 lies the horizon. The strain grows towards it, so
/// this only keeps a first step from going too far.
const double MIN_DEPTH = 0.05;

Patches patchesOf(const PlacedPhotograph& photograph)
{
    const MeshGrid& mesh = photograph.mesh;
    const Lattice& lattice = mesh.lattice();
    const double width = static_cast<double>(photograph.size.width) / lattice.cols();
    const double height = static_cast<double>(photograph.size.height) / lattice.rows();
    Patches patches;
    for (int cell = 0; cell < lattice.cellCount(); ++cell)
    {
        const Point2d a = mesh.vertex(cell, 0);
        const Point2d b = mesh.vertex(cell, 1);
        const Point2d c = mesh.vertex(cell, 2);
        const Point2d d = mesh.vertex(cell, 3);
        const Point2d du = (b - a + d - c) * (0.5 / width);
        const Point2d dv = (c - a + d - b) * (0.5 / height);
        const double area = du.cross(dv);
        if (area > 0 && std::isfinite(area))
            patches.push_back({0.25 * (a + b + c + d), {du.x, dv.x, du.y, dv.y}});
    }
    return patches;
}

/// d H p / d p
Matx22d jacobianOf(const Matx33d& h, Point2d p)
{
    const Vec3d q = h * Vec3d(p.x, p.y, 1);
    const double x = q[0] / q[2];
    const double y = q[1] / q[2];
    return Matx22d(h(0, 0) - x * h(2, 0), h(0, 1) - x * h(2, 1), h(1, 0) - y * h(2, 0), h(1, 1) - y * h(2, 1)) * (1 / q[2]);
}

/// The strain of all photographs under a view, as residuals whose squares add up to E.
class Strain
{
public:
    explicit Strain(const std::vector<PlacedPhotograph>& photographs)
    {
        Point2d sum;
        int count = 0;
        for (const PlacedPhotograph& photograph : photographs)
        {
            patches_.push_back(patchesOf(photograph));
            for (const Patch& patch : patches_.back())
                sum += patch.centre;
            count += static_cast<int>(patches_.back().size());
            vertices_.insert(vertices_.end(), photograph.mesh.vertices().begin(), photograph.mesh.vertices().end());
        }
        if (count == 0)
            return;
        const Point2d centre = sum / count;
        double squares = 0;
        for (const Patches& patches : patches_)
            for (const Patch& patch : patches)
                squares += (patch.centre - centre).dot(patch.centre - centre);
        const double radius = std::max(std::sqrt(squares / count), 1.0);
        normalised_ = {1 / radius, 0, -centre.x / radius, 0, 1 / radius, -centre.y / radius, 0, 0, 1};
    }

    const std::vector<Patches>& patches() const { return patches_; }

    /// In units of the spread of all patches around their centre, which it leaves at the origin.
    Matx33d view(const Unknowns& unknowns) const
    {
        // exp of the symmetric matrix [p q; q -p]: any stretch, and never a turn or a change of area.
        const double p = unknowns(0);
        const double q = unknowns(1);
        const double length = std::hypot(p, q);
        const double cosh = std::cosh(length);
        const double sinh = length > 0 ? std::sinh(length) / length : 1;
        return Matx33d(cosh + p * sinh, q * sinh, 0, q * sinh, cosh - p * sinh, 0, unknowns(2), unknowns(3), 1) * normalised_;
    }

    /// @return false if the view is none: a vertex at or behind the horizon, or not finite
    bool residuals(const Unknowns& unknowns, std::vector<double>& result) const
    {
        const Matx33d h = view(unknowns);
        for (const Point2d& v : vertices_)
            if (!(h(2, 0) * v.x + h(2, 1) * v.y + h(2, 2) >= MIN_DEPTH))
                return false;
        result.clear();
        for (const Patches& patches : patches_)
            append(h, patches, result);
        for (const double value : result)
            if (!std::isfinite(value))
                return false;
        return true;
    }

private:
    static void append(const Matx33d& h, const Patches& patches, std::vector<double>& result)
    {
        const size_t first = result.size();
        const double count = static_cast<double>(patches.size());
        const double weight = std::sqrt(0.5 / count);
        double mean = 0;
        for (const Patch& patch : patches)
        {
            const Matx22d j = jacobianOf(h, patch.centre) * patch.jacobian;
            const Matx22d squared = j.t() * j;
            const double middle = 0.5 * (squared(0, 0) + squared(1, 1));
            const Point2d uneven(0.5 * (squared(0, 0) - squared(1, 1)), squared(0, 1));
            const double length = norm(uneven);
            // ln s1 - ln s2 = artanh(length / middle), in the direction of `uneven`: smooth where both are equal.
            const double factor = length > 0 ? std::atanh(length / middle) / length : 1 / middle;
            const double area = std::log(determinant(j));
            mean += area / count;
            result.insert(result.end(), {weight * factor * uneven.x, weight * factor * uneven.y, weight * area});
        }
        for (size_t k = first + 2; k < result.size(); k += 3)
            result[k] -= weight * mean;
    }

    std::vector<Patches> patches_;
    std::vector<Point2d> vertices_;
    Matx33d normalised_ = Matx33d::eye();
};

double sumOfSquares(const std::vector<double>& values)
{
    double sum = 0;
    for (const double value : values)
        sum += value * value;
    return sum;
}

/// Gauss-Newton's step. False if a neighbour is no view, or the equations are singular.
bool gaussNewtonStep(const Strain& strain, const Unknowns& at, const std::vector<double>& residuals, Unknowns& step)
{
    std::vector<std::vector<double>> columns(UNKNOWNS);
    for (int k = 0; k < UNKNOWNS; ++k)
    {
        Unknowns offset = Unknowns::zeros();
        offset(k) = DIFFERENCE;
        std::vector<double> below;
        if (!strain.residuals(at + offset, columns[k]) || !strain.residuals(at - offset, below))
            return false;
        for (size_t i = 0; i < below.size(); ++i)
            columns[k][i] = (columns[k][i] - below[i]) / (2 * DIFFERENCE);
    }
    Matx<double, UNKNOWNS, UNKNOWNS> normal = Matx<double, UNKNOWNS, UNKNOWNS>::zeros();
    Unknowns right = Unknowns::zeros();
    for (size_t i = 0; i < residuals.size(); ++i)
        for (int k = 0; k < UNKNOWNS; ++k)
        {
            right(k) -= columns[k][i] * residuals[i];
            for (int l = 0; l < UNKNOWNS; ++l)
                normal(k, l) += columns[k][i] * columns[l][i];
        }
    return solve(normal, right, step, DECOMP_CHOLESKY);
}

/// The view of least strain, up to a similarity. Every step lowers the strain.
Unknowns leastStrain(const Strain& strain)
{
    Unknowns best = Unknowns::zeros();
    std::vector<double> residuals;
    if (!strain.residuals(best, residuals) || residuals.empty())
        return best;
    double energy = sumOfSquares(residuals);
    for (int iteration = 0; iteration < MAX_ITERATIONS; ++iteration)
    {
        Unknowns step;
        if (!gaussNewtonStep(strain, best, residuals, step))
            return best;
        bool lower = false;
        for (int halving = 0; halving <= MAX_HALVINGS && !lower; ++halving)
        {
            std::vector<double> next;
            lower = strain.residuals(best + step, next) && sumOfSquares(next) < energy;
            if (lower)
            {
                best += step;
                residuals = next;
                energy = sumOfSquares(next);
            }
            else
                step *= 0.5;
        }
        if (!lower || norm(step, NORM_INF) < STOP)
            return best;
    }
    return best;
}

/// By how much a view turns a photograph, radians; `area` receives the area of its pixels: the geometric mean, as one quad that
/// ran away would else shrink the picture.
double turnOf(const Matx33d& view, const Patches& patches, double& area)
{
    Point2d sum;
    double log_area = 0;
    for (const Patch& patch : patches)
    {
        const Matx22d j = jacobianOf(view, patch.centre) * patch.jacobian;
        sum += Point2d(j(0, 0) + j(1, 1), j(1, 0) - j(0, 1));
        log_area += std::log(determinant(j));
    }
    area = std::exp(log_area / static_cast<double>(patches.size()));
    return std::atan2(sum.y, sum.x);
}

} // namespace

Matx33d naturalView(const std::vector<PlacedPhotograph>& photographs)
{
    const Strain strain(photographs);
    const Matx33d view = strain.view(leastStrain(strain));
    double area = 0;
    double shown_area = 0;
    std::vector<double> turns;
    for (size_t i = 0; i < photographs.size(); ++i)
    {
        if (strain.patches()[i].empty())
            return Matx33d::eye();
        double scale = 0;
        turns.push_back(turnOf(view, strain.patches()[i], scale));
        area += photographs[i].size.area();
        shown_area += scale * photographs[i].size.area();
    }
    const double quarter = 0.5 * CV_PI;
    const double between = std::remainder(turns.front() - turns.back(), quarter);
    const double turn = -turns.back() - 0.5 * between;
    const double scale = std::sqrt(area / shown_area);
    const double c = scale * std::cos(turn);
    const double s = scale * std::sin(turn);
    return Matx33d(c, -s, 0, s, c, 0, 0, 0, 1) * view;
}

double largestStretch(const Matx33d& view, const std::vector<PlacedPhotograph>& photographs)
{
    double largest = 0;
    for (const PlacedPhotograph& photograph : photographs)
        for (const Patch& patch : patchesOf(photograph))
        {
            const Matx22d j = jacobianOf(view, patch.centre) * patch.jacobian;
            const Matx22d squared = j.t() * j;
            const double middle = 0.5 * (squared(0, 0) + squared(1, 1));
            const double uneven = std::hypot(0.5 * (squared(0, 0) - squared(1, 1)), squared(0, 1));
            largest = std::max(largest, std::sqrt(middle + uneven));
        }
    return largest;
}

} // namespace gcpw
} // namespace cv
