// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#include "energy/straightness_term.hpp"

#include <algorithm>
#include <cmath>

namespace cv
{
namespace gcpw
{

namespace
{

const size_t LEAST_SAMPLES = 4; ///< of a curve: two cannot bend, and three hardly

} // namespace

StraightnessTerm::StraightnessTerm(int image, const MeshGrid& rough, const std::vector<Curve>& curves, double step_px,
                                   double weight)
    : image_(image), weight_(weight)
{
    CV_CheckGT(step_px, 0.0, "Samples of curves need a positive step");
    for (const Curve& curve : curves)
    {
        std::vector<Sample> points;
        std::vector<double> passed; // along the rough curve, px
        for (const Point2d& p : resampled(curve, step_px))
        {
            if (!rough.lattice().contains(p)) // a mesh is not defined outside its image
                continue;
            Sample sample;
            sample.point = rough.lattice().locate(p);
            sample.rough = rough.warp(sample.point);
            passed.push_back(points.empty() ? 0 : passed.back() + norm(sample.rough - points.back().rough));
            points.push_back(sample);
        }
        if (points.size() < LEAST_SAMPLES || !(passed.back() > 0) || !std::isfinite(passed.back()))
            continue;
        std::vector<GroupRow> rows(points.size());
        for (size_t k = 0; k < points.size(); ++k)
        {
            const Point2d chord = points[std::min(k + 1, points.size() - 1)].rough - points[k > 0 ? k - 1 : 0].rough;
            const double length = norm(chord);
            const Point2d normal = length > 0 ? Point2d(-chord.y, chord.x) / length : Point2d();
            points[k].normal = normal;
            rows[k].cell = points[k].point.cell;
            rows[k].shared = {{-1, 1 - 2 * passed[k] / passed.back()}};
            for (int i = 0; i < 4; ++i)
            {
                rows[k].row[2 * i] = points[k].point.weight[i] * normal.x;
                rows[k].row[2 * i + 1] = points[k].point.weight[i] * normal.y;
            }
        }
        curves_.push_back({points, RowGroup(rough.lattice(), rows)});
    }
}

double StraightnessTerm::residuals(const Samples& curve, const State& state, std::vector<double>& result) const
{
    result.clear();
    for (const Sample& sample : curve.points)
        result.push_back(sample.normal.dot(state[image_].mesh.warp(sample.point) - sample.rough));
    return curve.rows.project(result);
}

double StraightnessTerm::evaluate(const State& state) const
{
    double energy = 0;
    std::vector<double> left;
    for (const Samples& curve : curves_)
        energy += weight_ * residuals(curve, state, left);
    return energy;
}

double StraightnessTerm::linearize(const State& state, NormalEquations& equations)
{
    double energy = 0;
    std::vector<double> left;
    for (const Samples& curve : curves_)
    {
        energy += weight_ * residuals(curve, state, left);
        equations.addGroup(image_, curve.rows, left, weight_);
    }
    return energy;
}

} // namespace gcpw
} // namespace cv
