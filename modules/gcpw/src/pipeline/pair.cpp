// Part of the GCPW module for OpenCV. Licence: Apache-2.0 (see LICENSE).
#include "opencv2/gcpw/pair.hpp"

#include "geometry/homography.hpp"
#include "imaging/photograph.hpp"
#include "matching/rough_alignment.hpp"
#include "pipeline/match_check.hpp"
#include "pipeline/pair_matcher.hpp"
#include "pipeline/result.hpp"

namespace cv
{
namespace gcpw
{

namespace
{

/// The working frames of both photographs and of what was matched at full resolution.
struct Frames
{
    Size source;
    Size target;
    FrameScale source_scale;
    FrameScale target_scale;

    Frames(Size full_source, Size full_target, double work_megapix)
        : source(cappedSize(full_source, work_megapix)), target(cappedSize(full_target, work_megapix)),
          source_scale(source, full_source), target_scale(target, full_target)
    {
    }
};

/// work = (full + 0.5) * scale - 0.5 as a matrix.
Matx33d workFromFull(const FrameScale& scale)
{
    return {scale.x, 0, 0.5 * scale.x - 0.5, 0, scale.y, 0.5 * scale.y - 0.5, 0, 0, 1};
}

Vec4d toFull(const Segment& segment, const FrameScale& scale)
{
    const Point2d start = scale.toFull(segment.start);
    const Point2d end = scale.toFull(segment.end);
    return {start.x, start.y, end.x, end.y};
}

Segment toWork(const Vec4d& line, const FrameScale& scale)
{
    Segment segment;
    segment.start = scale.toWork(Point2d(line[0], line[1]));
    segment.end = scale.toWork(Point2d(line[2], line[3]));
    return segment;
}

Features findFeatures(const Photograph& full, Size work_size, const Params& params)
{
    const Photograph photograph = resized(full, cappedSize(full.image.size(), params.featureMegapix));
    return detectFeatures(photograph.image, photograph.mask, work_size, params);
}

/// The source's lattice carried through the homography (between working frames), and the target's at rest.
Problem roughProblem(const Frames& frames, const Matx33d& target_from_source, const Params& params)
{
    Problem problem;
    problem.images.resize(2);
    MeshGrid& moving = problem.images[0].rough;
    moving = MeshGrid(Lattice(frames.source, params.meshCols, params.meshRows));
    for (Point2d& vertex : moving.vertices())
        vertex = applyHomography(target_from_source, vertex);
    problem.images[1].rough = MeshGrid(Lattice(frames.target, params.meshCols, params.meshRows));
    problem.images[1].held = true;
    return problem;
}

void setMatches(const MatchSet& matches, const Frames& frames, PairMatches& found)
{
    for (const PointMatch& match : matches.points)
    {
        found.source_points.push_back(frames.source_scale.toFull(match.a));
        found.target_points.push_back(frames.target_scale.toFull(match.b));
    }
    for (const LineMatch& match : matches.lines)
    {
        found.source_lines.push_back(toFull(match.a, frames.source_scale));
        found.target_lines.push_back(toFull(match.b, frames.target_scale));
        found.line_weights.push_back(match.weight);
    }
}

/// What a recipe uses of the matches.
MatchSet matchesFor(const Recipe& recipe, const PairMatches& found, const Frames& frames)
{
    MatchSet matches;
    for (size_t i = 0; recipe.points && i < found.source_points.size(); ++i)
    {
        PointMatch match;
        match.a = frames.source_scale.toWork(found.source_points[i]);
        match.b = frames.target_scale.toWork(found.target_points[i]);
        matches.points.push_back(match);
    }
    for (size_t i = 0; recipe.lines && i < found.source_lines.size(); ++i)
    {
        LineMatch match;
        match.a = toWork(found.source_lines[i], frames.source_scale);
        match.b = toWork(found.target_lines[i], frames.target_scale);
        match.weight = found.line_weights[i];
        matches.lines.push_back(match);
    }
    return matches;
}

PairMatches find(const Photograph& source, const Photograph& target, const Params& params, const Recipe& recipe,
                 const Progress& progress)
{
    PairMatches found;
    found.source_size = source.image.size();
    found.target_size = target.image.size();
    const Frames frames(found.source_size, found.target_size, params.workMegapix);
    const auto go_on = [&](const char* stage, double share)
    {
        if (!progress || progress(stage, share))
            return true;
        found.status = Status::CANCELLED;
        found.message = "cancelled before a rough alignment was found";
        return false;
    };

    int64 tick = getTickCount();
    if (!go_on("features", 0))
        return found;
    const Features source_features = findFeatures(source, frames.source, params);
    if (!go_on("features", 0.5))
        return found;
    const Features target_features = findFeatures(target, frames.target, params);
    found.timings_ms.features = millisecondsSince(tick);

    tick = getTickCount();
    if (!go_on("homography", 0))
        return found;
    const RoughAlignment rough = alignRoughly(source_features.keypoints, target_features.keypoints, source_features.segments,
                                              target_features.segments, frames.source);
    if (!rough.found)
    {
        found.status = Status::NO_ALIGNMENT;
        found.message = format("no alignment: %d keypoint matches, of which %d agree on a plausible homography; %d are needed",
                               rough.tentative, rough.inliers, MIN_MATCHES);
        return found;
    }
    found.target_from_source =
        workFromFull(frames.target_scale).inv() * rough.b_from_a * workFromFull(frames.source_scale);
    const Problem problem = roughProblem(frames, rough.b_from_a, params);
    setMatches(matchPair(source_features, target_features, problem.images[0].rough, problem.images[1].rough, Point2d(), params,
                         recipe),
               frames, found);
    found.timings_ms.homography = millisecondsSince(tick);
    return found;
}

/// @param spent_ms on the matches
Alignment align(const Photograph& source, const Photograph& target, const PairMatches& matches, const Params& params,
                const Progress& progress, double spent_ms)
{
    const int64 start = getTickCount();
    Report report;
    report.status = matches.status;
    report.message = matches.message;
    report.timings_ms.features = matches.timings_ms.features;
    report.timings_ms.homography = matches.timings_ms.homography;
    if (matches.status != Status::OK)
        return Alignment(std::vector<Alignment::Image>(), Size2d(1, 1), report);

    const Frames frames(matches.source_size, matches.target_size, params.workMegapix);
    const Photograph source_work = resized(source, frames.source);
    const Photograph target_work = resized(target, frames.target);
    const int64 tick = getTickCount();
    Problem problem = roughProblem(
        frames, workFromFull(frames.target_scale) * matches.target_from_source * workFromFull(frames.source_scale).inv(), params);
    ProblemPair pair;
    pair.a = 0;
    pair.b = 1;
    pair.matches = matchesFor(recipeOf(params.method), matches, frames);
    problem.pairs.push_back(pair);
    problem.images[0].pyramid = buildPyramid(source_work.image, source_work.mask, params.pyramidLevels);
    problem.images[1].pyramid = buildPyramid(target_work.image, target_work.mask, params.pyramidLevels);
    std::vector<ImageState> states = roughStates(problem);
    refine(problem, params, [&](double share) { return !progress || progress("align", share); }, states, report);
    report.timings_ms.align = millisecondsSince(tick);
    report.timings_ms.total = spent_ms + millisecondsSince(start);
    return Alignment({toImage(problem.images[0].rough, states[0], matches.source_size),
                      toImage(problem.images[1].rough, states[1], matches.target_size)},
                     Size2d(frames.target_scale.x, frames.target_scale.y), report);
}

} // namespace

PairMatches findPairMatches(InputArray source, InputArray target, const Params& params, const Progress& progress)
{
    params.check();
    return find(toPhotograph(source, "source"), toPhotograph(target, "target"), params, recipeOf(Method::GCPW), progress);
}

Alignment alignPair(InputArray source_input, InputArray target_input, const Params& params, const Progress& progress)
{
    params.check();
    const int64 start = getTickCount();
    const Photograph source = toPhotograph(source_input, "source");
    const Photograph target = toPhotograph(target_input, "target");
    const PairMatches matches = find(source, target, params, recipeOf(params.method), progress);
    return align(source, target, matches, params, progress, millisecondsSince(start));
}

Alignment alignPair(InputArray source_input, InputArray target_input, const PairMatches& matches, const Params& params,
                    const Progress& progress)
{
    params.check();
    const Photograph source = toPhotograph(source_input, "source");
    const Photograph target = toPhotograph(target_input, "target");
    checkMatches(matches, source.image.size(), target.image.size());
    return align(source, target, matches, params, progress,
                 matches.timings_ms.features + matches.timings_ms.homography);
}

} // namespace gcpw
} // namespace cv
