// Part of the GCPW module for OpenCV. Licence: Apache-2.0 (see LICENSE).
#include "terms/line_term.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace cv
{
namespace gcpw
{

LineTerm::LineTerm(int image_a, int image_b, const Lattice& lattice_a, const Lattice& lattice_b,
                   const std::vector<LineMatch>& matches, double step_px, double weight, Point2d shift_b)
    : image_a_(image_a), image_b_(image_b), shift_b_(shift_b)
{
    CV_CheckGT(step_px, 0.0, "Line samples need a positive step");
    for (const LineMatch& match : matches)
    {
        Partner partner;
        const int count = std::max(static_cast<int>(match.a.length() / step_px), 1);
        // Without a direction there is no line, and beyond its image a mesh knows nothing.
        for (int k = 0; match.b.length() > 0 && k <= count; ++k)
        {
            const Point2d sample = match.a.at(static_cast<double>(k) / count);
            if (lattice_a.contains(sample))
                partner.samples.push_back(lattice_a.locate(sample));
        }
        partner.rest_b = match.b;
        partner.start_b = lattice_b.locate(match.b.start);
        partner.end_b = lattice_b.locate(match.b.end);
        partner.weight = weight * match.weight;
        partners_.push_back(partner);
    }
}

Segment LineTerm::partnerNow(const Partner& partner, const MeshGrid& b) const
{
    return {b.warp(partner.start_b) + shift_b_, b.warp(partner.end_b) + shift_b_};
}

double LineTerm::linearize(const MeshGrid& a, const MeshGrid& b, const RobustLoss& loss, ResidualSink& sink) const
{
    double energy = 0;
    for (const Partner& partner : partners_)
    {
        if (partner.samples.empty())
            continue;
        const Segment now = partnerNow(partner, b);
        const Line line = now.line();
        const double squared_length = now.direction().dot(now.direction());
        for (const CellPoint& sample : partner.samples)
        {
            const Point2d canvas = a.warp(sample);
            const double r = line.distance(canvas);
            energy += partner.weight * loss.value(r * r);
            // The point of b beside the sample, kept on the segment: beyond its ends b is not known.
            const double t = (canvas - now.start).dot(now.direction()) / squared_length;
            const CellPoint foot = b.lattice().locate(partner.rest_b.at(std::min(std::max(t, 0.0), 1.0)));
            QuadRow row_a{};
            QuadRow row_b{};
            for (int k = 0; k < 4; ++k)
            {
                row_a[2 * k] = sample.weight[k] * line.normal.x;
                row_a[2 * k + 1] = sample.weight[k] * line.normal.y;
                row_b[2 * k] = -foot.weight[k] * line.normal.x;
                row_b[2 * k + 1] = -foot.weight[k] * line.normal.y;
            }
            sink.addRow({image_a_, sample.cell}, row_a, {image_b_, foot.cell}, row_b, r,
                        partner.weight * loss.weight(r * r));
        }
    }
    return energy;
}

std::vector<double> LineTerm::distances(const MeshGrid& a, const MeshGrid& b) const
{
    std::vector<double> result;
    for (const Partner& partner : partners_)
    {
        if (partner.samples.empty())
        {
            result.push_back(std::numeric_limits<double>::infinity());
            continue;
        }
        const Line line = partnerNow(partner, b).line();
        double sum = 0;
        for (const CellPoint& sample : partner.samples)
            sum += line.distance(a.warp(sample)) * line.distance(a.warp(sample));
        result.push_back(std::sqrt(sum / partner.samples.size()));
    }
    return result;
}

} // namespace gcpw
} // namespace cv
