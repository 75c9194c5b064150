// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#include "api/result.hpp"

#include <algorithm>
#include <limits>
#include <opencv2/core/utils/logger.hpp>
#include "optimization/decorrelation.hpp"

namespace cv
{
namespace gcpw
{

namespace
{

Mat toMat(const MeshGrid& mesh)
{
    Mat result(mesh.lattice().rows() + 1, mesh.lattice().cols() + 1, CV_64FC2);
    for (int i = 0; i < mesh.lattice().vertexCount(); ++i)
        result.at<Vec2d>(i / result.cols, i % result.cols) = Vec2d(mesh.vertices()[i].x, mesh.vertices()[i].y);
    return result;
}

void measure(const Problem& problem, const std::vector<ImageState>& states, Report& report)
{
    report.folds = 0;
    report.max_displacement_px = 0;
    report.gain_min = std::numeric_limits<double>::max();
    report.gain_max = -report.gain_min;
    for (size_t i = 0; i < states.size(); ++i)
    {
        report.folds += states[i].mesh.countFolds();
        report.max_displacement_px =
            std::max(report.max_displacement_px, maxVertexDistance(states[i].mesh, problem.images[i].rough));
        for (int cell = 0; cell < states[i].mesh.lattice().cellCount(); ++cell)
            for (const ChannelAffine& map : states[i].color.quad(cell))
            {
                report.gain_min = std::min(report.gain_min, map.gain);
                report.gain_max = std::max(report.gain_max, map.gain);
            }
    }
}

} // namespace

std::vector<ImageState> roughStates(const Problem& problem)
{
    std::vector<ImageState> states(problem.images.size());
    for (size_t i = 0; i < states.size(); ++i)
    {
        states[i].mesh = problem.images[i].rough;
        states[i].color = ColorGrid(states[i].mesh.lattice());
    }
    return states;
}

void refine(const Problem& problem, const Params& params, const StepCallback& progress, std::vector<ImageState>& states,
            Report& report)
{
    const std::vector<ImageState> rough = roughStates(problem);
    CoarseToFine optimizer(problem, params);
    switch (optimizer.run(states, report.levels, progress))
    {
    case OptimizeStatus::Done:
        break;
    case OptimizeStatus::MatchesKept:
        report.message = "pixels made the alignment worse; the meshes of the matches alone were kept";
        break;
    case OptimizeStatus::RoughAligned:
        report.message = "the rough alignment lines the images up already; only colours were estimated";
        break;
    case OptimizeStatus::RoughKept:
        report.status = Status::ROUGH;
        report.message = "the refinement gains too little over the rough alignment for what it changes; the rough alignment was kept";
        break;
    case OptimizeStatus::PixelsSingular:
        report.message = "the normal equations of a level with pixels are singular; its last good state was kept";
        break;
    case OptimizeStatus::MatchesSingular:
        report.status = Status::ROUGH;
        report.message = "the normal equations of the matches are singular; the rough alignment was kept";
        states = rough;
        break;
    case OptimizeStatus::Cancelled:
        report.status = Status::CANCELLED;
        report.message = "cancelled; the rough alignment was kept";
        states = rough;
        break;
    }
    if (!report.message.empty())
        CV_LOG_INFO(nullptr, "gcpw: " << report.message);
    measure(problem, states, report);
    report.pairs.resize(problem.pairs.size());
    const bool chosen = !optimizer.choice().before.empty();
    const std::vector<Decorrelation> before = chosen ? optimizer.choice().before : decorrelations(problem, rough);
    const std::vector<Decorrelation> after = chosen ? optimizer.choice().after : before;
    for (size_t k = 0; k < problem.pairs.size(); ++k)
    {
        const ProblemPair& pair = problem.pairs[k];
        PairReport& item = report.pairs[k];
        item.a = pair.a;
        item.b = pair.b;
        item.points = static_cast<int>(pair.matches.points.size());
        item.lines = static_cast<int>(pair.matches.lines.size());
        item.miss_before = 100 * before[k].rms();
        item.miss_after = 100 * after[k].rms();
    }
}

Alignment::Image toImage(const MeshGrid& rough, const ImageState& state, Size full_size)
{
    Alignment::Image image;
    image.full_size = full_size;
    image.work_size = state.mesh.lattice().imageSize();
    image.mesh = toMat(state.mesh);
    image.rough = toMat(rough);
    image.color = state.color.toMat();
    return image;
}

MeshGrid meshOf(const Alignment::Image& image)
{
    MeshGrid mesh(Lattice(image.work_size, image.color.cols, image.color.rows));
    for (int i = 0; i < mesh.lattice().vertexCount(); ++i)
    {
        const Vec2d v = image.mesh.at<Vec2d>(i / image.mesh.cols, i % image.mesh.cols);
        mesh.vertices()[i] = Point2d(v[0], v[1]);
    }
    return mesh;
}

Alignment Alignment::rough() const
{
    Alignment result = *this;
    for (Image& image : result.images_)
    {
        image.mesh = image.rough;
        image.color = ColorGrid(Lattice(image.work_size, image.color.cols, image.color.rows)).toMat();
    }
    return result;
}

double millisecondsSince(int64 start)
{
    return 1000.0 * static_cast<double>(getTickCount() - start) / getTickFrequency();
}

} // namespace gcpw
} // namespace cv
