// Part of the GCPW module for OpenCV. Licence: Apache-2.0 (see LICENSE).
#include "opencv2/gcpw/pair.hpp"

#include <opencv2/core/utils/logger.hpp>
#include "geometry/homography.hpp"
#include "imaging/photograph.hpp"
#include "imaging/score.hpp"
#include "matching/rough_alignment.hpp"
#include "model/inverse_map.hpp"
#include "pipeline/optimizer.hpp"
#include "pipeline/pair_matcher.hpp"

namespace cv
{
namespace gcpw
{

namespace
{

double millisecondsSince(int64 start)
{
    return 1000.0 * static_cast<double>(getTickCount() - start) / getTickFrequency();
}

Mat toMat(const MeshGrid& mesh)
{
    Mat result(mesh.lattice().rows() + 1, mesh.lattice().cols() + 1, CV_64FC2);
    for (int i = 0; i < mesh.lattice().vertexCount(); ++i)
        result.at<Vec2d>(i / result.cols, i % result.cols) = Vec2d(mesh.vertices()[i].x, mesh.vertices()[i].y);
    return result;
}

Alignment::Image toImage(const ImageState& state, const MeshGrid& rough, Size full)
{
    Alignment::Image image;
    image.full_size = full;
    image.work_size = state.mesh.lattice().imageSize();
    image.mesh = toMat(state.mesh);
    image.rough = toMat(rough);
    image.color = state.color.toMat();
    return image;
}

} // namespace

Alignment alignPair(InputArray source_input, InputArray target_input, const Params& params, const Progress& progress)
{
    params.check();
    const int64 start = getTickCount();
    const Photograph full[2] = {toPhotograph(source_input, "source"), toPhotograph(target_input, "target")};
    const auto report_progress = [&](const char* stage, double share) { return !progress || progress(stage, share); };
    Report report;
    Photograph work[2];
    Features features[2];
    int64 tick = getTickCount();
    for (int i = 0; i < 2; ++i)
    {
        report_progress("features", 0.5 * i);
        const Size size = full[i].image.size();
        work[i] = resized(full[i], cappedSize(size, params.workMegapix));
        features[i] = detectFeatures(resized(full[i], cappedSize(size, params.featureMegapix)).image,
                                     work[i].image.size(), params);
    }
    report.timings_ms.features = millisecondsSince(tick);
    tick = getTickCount();
    report_progress("homography", 0);
    const RoughAlignment rough = alignRoughly(features[0].keypoints, features[1].keypoints, features[0].segments,
                                              features[1].segments, work[0].image.size());
    if (!rough.found)
    {
        report.status = Status::NO_ALIGNMENT;
        report.message = format("no alignment: %d keypoint matches, %d of them agree on a plausible homography, %d are needed",
                                rough.tentative, rough.inliers, MIN_MATCHES);
        return Alignment({}, Size2d(1, 1), report);
    }
    const Lattice lattice_a(work[0].image.size(), params.meshCols, params.meshRows);
    const Lattice lattice_b(work[1].image.size(), params.meshCols, params.meshRows);
    std::vector<ImageState> states(2);
    states[0].mesh = MeshGrid(lattice_a);
    for (Point2d& v : states[0].mesh.vertices())
        v = applyHomography(rough.b_from_a, v);
    states[1].mesh = MeshGrid(lattice_b);
    states[0].color = ColorGrid(lattice_a);
    states[1].color = ColorGrid(lattice_b);
    Problem problem;
    problem.images.resize(2);
    for (int i = 0; i < 2; ++i)
        problem.images[i].rough = states[i].mesh;
    problem.images[1].held = true;
    const Recipe recipe = recipeOf(params.method);
    ProblemPair pair;
    pair.a = 0;
    pair.b = 1;
    MeshGrid fitted;
    pair.matches = matchPair(features[0], features[1], states[0].mesh, states[1].mesh, params, recipe, fitted);
    problem.pairs.push_back(pair);
    report.timings_ms.homography = millisecondsSince(tick);
    tick = getTickCount();
    if (recipe.pixels)
        for (int i = 0; i < 2; ++i)
            problem.images[i].pyramid = buildPyramid(work[i].image, work[i].mask, params.pyramidLevels);
    if (recipe.movesMesh())
        states[0].mesh = fitted;
    Optimizer optimizer(problem, params);
    const OptimizeStatus status = optimizer.run(recipe, states, report.levels,
                                                [&](double share) { return report_progress("align", share); });
    CV_UNUSED(status);
    report.timings_ms.align = millisecondsSince(tick);
    PairReport pair_report;
    pair_report.points = static_cast<int>(pair.matches.points.size());
    pair_report.lines = static_cast<int>(pair.matches.lines.size());
    report.pairs.push_back(pair_report);
    report.folds = states[0].mesh.countFolds();
    report.max_displacement_px = maxVertexDistance(states[0].mesh, problem.images[0].rough);
    report.gain_min = 1e9;
    report.gain_max = -1e9;
    for (int cell = 0; cell < lattice_a.cellCount(); ++cell)
        for (const ChannelAffine& map : states[0].color.quad(cell))
        {
            report.gain_min = std::min(report.gain_min, map.gain);
            report.gain_max = std::max(report.gain_max, map.gain);
        }
    report.timings_ms.total = millisecondsSince(start);
    const Size2d scale(static_cast<double>(work[1].image.cols) / full[1].image.cols,
                       static_cast<double>(work[1].image.rows) / full[1].image.rows);
    return Alignment({toImage(states[0], problem.images[0].rough, full[0].image.size()),
                      toImage(states[1], problem.images[1].rough, full[1].image.size())},
                     scale, report);
}

} // namespace gcpw
} // namespace cv
