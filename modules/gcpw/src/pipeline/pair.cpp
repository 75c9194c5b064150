// Part of the GCPW module for OpenCV. Licence: Apache-2.0 (see LICENSE).
#include "opencv2/gcpw/pair.hpp"

#include "geometry/homography.hpp"
#include "imaging/photograph.hpp"
#include "matching/rough_alignment.hpp"
#include "pipeline/pair_matcher.hpp"
#include "pipeline/result.hpp"

namespace cv
{
namespace gcpw
{

namespace
{

/// One of the two photographs on its way through the stages.
struct Side
{
    Photograph full;
    Photograph work;
    Features features;

    Size workSize() const { return work.image.size(); }
};

Side prepare(InputArray input, const char* name, const Params& params)
{
    Side side;
    side.full = toPhotograph(input, name);
    const Size size = side.full.image.size();
    side.work = resized(side.full, cappedSize(size, params.workMegapix));
    return side;
}

void findFeatures(Side& side, const Params& params)
{
    const Photograph photograph = resized(side.full, cappedSize(side.full.image.size(), params.featureMegapix));
    side.features = detectFeatures(photograph.image, photograph.mask, side.workSize(), params);
}

/// The source's lattice carried through the homography, and the target's at rest.
Problem roughProblem(const Side& source, const Side& target, const Matx33d& target_from_source, const Params& params)
{
    Problem problem;
    problem.images.resize(2);
    MeshGrid& moving = problem.images[0].rough;
    moving = MeshGrid(Lattice(source.workSize(), params.meshCols, params.meshRows));
    for (Point2d& vertex : moving.vertices())
        vertex = applyHomography(target_from_source, vertex);
    problem.images[1].rough = MeshGrid(Lattice(target.workSize(), params.meshCols, params.meshRows));
    problem.images[1].held = true;
    return problem;
}

Alignment failure(Report report, Status status, const std::string& message)
{
    report.status = status;
    report.message = message;
    return Alignment(std::vector<Alignment::Image>(), Size2d(1, 1), report);
}

} // namespace

Alignment alignPair(InputArray source_input, InputArray target_input, const Params& params, const Progress& progress)
{
    params.check();
    const int64 start = getTickCount();
    Side source = prepare(source_input, "source", params);
    Side target = prepare(target_input, "target", params);
    const auto go_on = [&](const char* stage, double share) { return !progress || progress(stage, share); };
    Report report;

    int64 tick = getTickCount();
    for (Side* side : {&source, &target})
    {
        if (!go_on("features", side == &source ? 0 : 0.5))
            return failure(report, Status::CANCELLED, "cancelled before a rough alignment was found");
        findFeatures(*side, params);
    }
    report.timings_ms.features = millisecondsSince(tick);

    tick = getTickCount();
    if (!go_on("homography", 0))
        return failure(report, Status::CANCELLED, "cancelled before a rough alignment was found");
    const RoughAlignment rough = alignRoughly(source.features.keypoints, target.features.keypoints, source.features.segments,
                                              target.features.segments, source.workSize());
    if (!rough.found)
        return failure(report, Status::NO_ALIGNMENT,
                       format("no alignment: %d keypoint matches, of which %d agree on a plausible homography; %d are needed",
                              rough.tentative, rough.inliers, MIN_MATCHES));
    Problem problem = roughProblem(source, target, rough.b_from_a, params);
    const Recipe recipe = recipeOf(params.method);
    ProblemPair pair;
    pair.a = 0;
    pair.b = 1;
    pair.matches = matchPair(source.features, target.features, problem.images[0].rough, problem.images[1].rough, Point2d(), params,
                             recipe);
    problem.pairs.push_back(pair);
    report.timings_ms.homography = millisecondsSince(tick);

    tick = getTickCount();
    problem.images[0].pyramid = buildPyramid(source.work.image, source.work.mask, params.pyramidLevels);
    problem.images[1].pyramid = buildPyramid(target.work.image, target.work.mask, params.pyramidLevels);
    std::vector<ImageState> states = roughStates(problem);
    refine(problem, params, [&](double share) { return go_on("align", share); }, states, report);
    report.timings_ms.align = millisecondsSince(tick);
    report.timings_ms.total = millisecondsSince(start);

    const FrameScale canvas(target.workSize(), target.full.image.size());
    return Alignment({toImage(problem.images[0].rough, states[0], source.full.image.size()),
                      toImage(problem.images[1].rough, states[1], target.full.image.size())},
                     Size2d(canvas.x, canvas.y), report);
}

} // namespace gcpw
} // namespace cv
