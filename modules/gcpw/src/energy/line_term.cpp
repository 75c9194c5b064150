// Part of the GCPW module for OpenCV. Licence: Apache-2.0 (see LICENSE).
#include "energy/line_term.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace cv
{
namespace gcpw
{

namespace
{

const double MAX_SAMPLES = 10000; ///< of a segment: no image that fits into memory has longer lines at the default step
const double FARTHEST = 1e8;      ///< px: a cell's index would overflow for points beyond

/// Also false for what is not a number.
bool isPlace(Point2d p)
{
    return std::abs(p.x) < FARTHEST && std::abs(p.y) < FARTHEST;
}

/// Whether a match says anything: without a direction there is no line.
bool isUsable(const LineMatch& match)
{
    const bool places = isPlace(match.a.start) && isPlace(match.a.end) && isPlace(match.b.start) && isPlace(match.b.end);
    return places && match.b.length() > 0 && match.weight >= 0 && std::isfinite(match.weight);
}

} // namespace

LineTerm::LineTerm(int image_a, int image_b, const Lattice& lattice_a, const Lattice& lattice_b,
                   const std::vector<LineMatch>& matches, double step_px, double weight, Point2d shift_b)
    : image_a_(image_a), image_b_(image_b), shift_b_(shift_b)
{
    CV_CheckGT(step_px, 0.0, "Line samples need a positive step");
    for (const LineMatch& match : matches)
    {
        Partner target;
        if (!isUsable(match))
        {
            targets_.push_back(target); // keeps its place in the order, without samples
            continue;
        }
        const int count = static_cast<int>(std::min(std::max(match.a.length() / step_px, 1.0), MAX_SAMPLES));
        for (int k = 0; k <= count; ++k)
        {
            const Point2d sample = match.a.at(static_cast<double>(k) / count);
            if (lattice_a.contains(sample)) // beyond its image a mesh knows nothing
                target.samples.push_back(lattice_a.locate(sample));
        }
        target.reference_b = match.b;
        target.start_b = lattice_b.locate(match.b.start);
        target.end_b = lattice_b.locate(match.b.end);
        target.weight = weight * match.weight;
        targets_.push_back(target);
    }
}

Segment LineTerm::targetNow(const Partner& target, const MeshGrid& b) const
{
    return {b.warp(target.start_b) + shift_b_, b.warp(target.end_b) + shift_b_};
}

double LineTerm::linearize(const MeshGrid& a, const MeshGrid& b, const RobustLoss& loss, NormalEquations& equations) const
{
    double energy = 0;
    for (const Partner& target : targets_)
    {
        if (target.samples.empty())
            continue;
        const Segment now = targetNow(target, b);
        const double squared_length = now.direction().dot(now.direction());
        if (squared_length == 0) // what is not a number goes on, for the solver to refuse
            continue;
        const Line line = now.line();
        for (const CellPoint& sample : target.samples)
        {
            const Point2d canvas = a.warp(sample);
            const double r = line.distance(canvas);
            energy += target.weight * loss.value(r * r);
            // The point of b beside the sample, kept on the segment: beyond its ends b is not known.
            const double t = (canvas - now.start).dot(now.direction()) / squared_length;
            const CellPoint foot = b.lattice().locate(target.reference_b.at(t > 0 ? std::min(t, 1.0) : 0.0));
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
                        target.weight * loss.weight(r * r));
        }
    }
    return energy;
}

std::vector<double> LineTerm::distances(const MeshGrid& a, const MeshGrid& b) const
{
    std::vector<double> result;
    for (const Partner& target : targets_)
    {
        if (target.samples.empty())
        {
            result.push_back(std::numeric_limits<double>::infinity());
            continue;
        }
        const Segment now = targetNow(target, b);
        if (now.direction().dot(now.direction()) == 0)
        {
            result.push_back(std::numeric_limits<double>::infinity());
            continue;
        }
        const Line line = now.line();
        double sum = 0;
        for (const CellPoint& sample : target.samples)
            sum += line.distance(a.warp(sample)) * line.distance(a.warp(sample));
        result.push_back(std::sqrt(sum / target.samples.size()));
    }
    return result;
}

} // namespace gcpw
} // namespace cv
