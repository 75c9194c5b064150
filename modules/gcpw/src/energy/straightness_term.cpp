// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#include "energy/straightness_term.hpp"

#include <algorithm>
#include <cmath>
#include "solver/projected_rows.hpp"

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
        Samples samples;
        double length = 0;
        for (const Point2d& p : resampled(curve, step_px))
        {
            if (!rough.lattice().contains(p)) // a mesh is not defined outside its image
                continue;
            Sample sample;
            sample.point = rough.lattice().locate(p);
            sample.rough = rough.warp(sample.point);
            if (!samples.empty())
                length += std::hypot(sample.rough.x - samples.back().rough.x, sample.rough.y - samples.back().rough.y);
            sample.length = length;
            samples.push_back(sample);
        }
        if (samples.size() < LEAST_SAMPLES || !(length > 0) || !std::isfinite(length))
            continue;
        for (size_t k = 0; k < samples.size(); ++k)
        {
            const Point2d chord = samples[std::min(k + 1, samples.size() - 1)].rough - samples[k > 0 ? k - 1 : 0].rough;
            const double norm = std::hypot(chord.x, chord.y);
            samples[k].normal = norm > 0 ? Point2d(-chord.y, chord.x) / norm : Point2d();
            samples[k].length = 2 * samples[k].length / length - 1;
        }
        curves_.push_back(samples);
    }
}

void StraightnessTerm::residuals(const Samples& samples, const State& state, std::vector<GroupRow>& rows) const
{
    rows.resize(samples.size());
    for (size_t k = 0; k < samples.size(); ++k)
    {
        const Sample& sample = samples[k];
        rows[k].cell = sample.point.cell;
        rows[k].residual = sample.normal.dot(state[image_].mesh.warp(sample.point) - sample.rough);
        rows[k].shared = {{-1, -sample.length}};
    }
}

double StraightnessTerm::evaluate(const State& state) const
{
    double energy = 0;
    std::vector<GroupRow> rows;
    for (const Samples& samples : curves_)
    {
        residuals(samples, state, rows);
        for (const double r : projectOut(rows).residuals)
            energy += weight_ * r * r;
    }
    return energy;
}

double StraightnessTerm::linearize(const State& state, NormalEquations& equations)
{
    std::vector<GroupRow> rows;
    for (const Samples& samples : curves_)
    {
        residuals(samples, state, rows);
        for (size_t k = 0; k < samples.size(); ++k)
            for (int i = 0; i < 4; ++i)
            {
                rows[k].row[2 * i] = samples[k].point.weight[i] * samples[k].normal.x;
                rows[k].row[2 * i + 1] = samples[k].point.weight[i] * samples[k].normal.y;
            }
        equations.addGroup(image_, rows, weight_);
    }
    return evaluate(state);
}

} // namespace gcpw
} // namespace cv
