// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#include "energy/line_term.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include "geometry/curve.hpp"

namespace cv
{
namespace gcpw
{

namespace
{

const double FARTHEST = 1e8; ///< px: a cell's index would overflow for points beyond

/// Also false for what is not a number.
bool isPlace(Point2d p)
{
    return std::abs(p.x) < FARTHEST && std::abs(p.y) < FARTHEST;
}

/// Whether a match can be used: without a direction there is no line.
bool isUsable(const LineMatch& match)
{
    const bool places = isPlace(match.a.start) && isPlace(match.a.end) && isPlace(match.b.start) && isPlace(match.b.end);
    return places && match.b.length() > 0 && match.weight >= 0 && std::isfinite(match.weight);
}

} // namespace

LineTerm::LineTerm(int image_a, int image_b, const Lattice& lattice_a, const Lattice& lattice_b,
                   const std::vector<LineMatch>& matches, double step_px, double weight, const RobustLoss& loss,
                   Point2d shift_b)
    : image_a_(image_a), image_b_(image_b), loss_(loss), shift_b_(shift_b)
{
    CV_CheckGT(step_px, 0.0, "Line samples need a positive step");
    for (const LineMatch& match : matches)
    {
        Target target;
        if (!isUsable(match))
        {
            targets_.push_back(target); // keeps its place in the order, without samples
            continue;
        }
        const int count = static_cast<int>(std::min(std::max(match.a.length() / step_px, 1.0), MAX_SAMPLES));
        for (int k = 0; k <= count; ++k)
        {
            const Point2d sample = match.a.at(static_cast<double>(k) / count);
            if (lattice_a.contains(sample)) // a mesh is not defined outside its image
                target.samples.push_back(lattice_a.locate(sample));
        }
        target.reference_b = match.b;
        target.start_b = lattice_b.locate(match.b.start);
        target.end_b = lattice_b.locate(match.b.end);
        target.weight = weight * match.weight;
        targets_.push_back(target);
    }
}

bool LineTerm::lineNow(const Target& target, const State& state, Segment& segment) const
{
    if (target.samples.empty())
        return false;
    const MeshGrid& b = state[image_b_].mesh;
    segment = {b.warp(target.start_b) + shift_b_, b.warp(target.end_b) + shift_b_};
    return segment.direction().dot(segment.direction()) != 0; // NaN is passed on, for the solver to refuse
}

double LineTerm::evaluate(const State& state) const
{
    double energy = 0;
    Segment now;
    for (const Target& target : targets_)
    {
        if (!lineNow(target, state, now))
            continue;
        const Line line = now.line();
        for (const CellPoint& sample : target.samples)
        {
            const double r = line.distance(state[image_a_].mesh.warp(sample));
            energy += target.weight * loss_.value(r * r);
        }
    }
    return energy;
}

double LineTerm::linearize(const State& state, NormalEquations& equations)
{
    const MeshGrid& a = state[image_a_].mesh;
    const Lattice& lattice_b = state[image_b_].mesh.lattice();
    double energy = 0;
    Segment now;
    for (const Target& target : targets_)
    {
        if (!lineNow(target, state, now))
            continue;
        const Line line = now.line();
        const double squared_length = now.direction().dot(now.direction());
        for (const CellPoint& sample : target.samples)
        {
            const Point2d canvas = a.warp(sample);
            const double r = line.distance(canvas);
            energy += target.weight * loss_.value(r * r);
            // The point of b next to the sample, clamped to the segment: beyond its ends b is not known.
            const double t = (canvas - now.start).dot(now.direction()) / squared_length;
            const CellPoint foot = lattice_b.locate(target.reference_b.at(t > 0 ? std::min(t, 1.0) : 0.0));
            QuadRow row_a{};
            QuadRow row_b{};
            for (int k = 0; k < 4; ++k)
            {
                row_a[2 * k] = sample.weight[k] * line.normal.x;
                row_a[2 * k + 1] = sample.weight[k] * line.normal.y;
                row_b[2 * k] = -foot.weight[k] * line.normal.x;
                row_b[2 * k + 1] = -foot.weight[k] * line.normal.y;
            }
            equations.addRow({image_a_, sample.cell}, row_a, {image_b_, foot.cell}, row_b, r,
                             target.weight * loss_.weight(r * r));
        }
    }
    return energy;
}

std::vector<double> LineTerm::distances(const State& state) const
{
    std::vector<double> result;
    Segment now;
    for (const Target& target : targets_)
    {
        if (!lineNow(target, state, now))
        {
            result.push_back(std::numeric_limits<double>::infinity());
            continue;
        }
        const Line line = now.line();
        double sum = 0;
        for (const CellPoint& sample : target.samples)
        {
            const double r = line.distance(state[image_a_].mesh.warp(sample));
            sum += r * r;
        }
        result.push_back(std::sqrt(sum / static_cast<double>(target.samples.size())));
    }
    return result;
}

} // namespace gcpw
} // namespace cv
