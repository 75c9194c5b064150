// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#include "opencv2/gcpw/pair.hpp"

#include "api/known_matches.hpp"
#include "api/match_check.hpp"
#include "api/problem_builder.hpp"

namespace cv
{
namespace gcpw
{

namespace
{

std::vector<Mat> checkedPair(InputArray source, InputArray target)
{
    const std::vector<Mat> images = {source.getMat(), target.getMat()};
    checkPhotograph(images[0], "source");
    checkPhotograph(images[1], "target");
    return images;
}

/// From both photographs to their matches.
void match(ProblemBuilder& builder, MatchKinds kinds)
{
    builder.findFeatures();
    builder.startFromHomography();
    builder.findMatches(kinds);
}

} // namespace

PairMatches findPairMatches(InputArray source, InputArray target, const Params& params, const Progress& progress)
{
    params.check();
    const std::vector<Mat> images = checkedPair(source, target);
    ProblemBuilder builder(images, std::vector<Mat>(), ScaleRule::EACH, params, progress);
    match(builder, matchesUsedBy(Method::GCPW));
    PairMatches found;
    found.status = builder.report().status;
    found.message = builder.report().message;
    found.source_size = images[0].size();
    found.target_size = images[1].size();
    found.timings_ms = builder.report().timings_ms;
    if (found.status == Status::OK)
        setMatches(builder.start().canvas_from_image[0], builder.problem().pairs[0].matches, builder.images(), found);
    return found;
}

Alignment alignPair(InputArray source, InputArray target, const Params& params)
{
    return alignPair(source, target, params, Progress());
}

Alignment alignPair(InputArray source, InputArray target, const Params& params, const Progress& progress)
{
    params.check();
    ProblemBuilder builder(checkedPair(source, target), std::vector<Mat>(), ScaleRule::EACH, params, progress);
    match(builder, matchesUsedBy(params.method));
    builder.keepStraight();
    return builder.align();
}

Alignment alignPair(InputArray source, InputArray target, const PairMatches& matches, const Params& params,
                    const Progress& progress)
{
    params.check();
    const std::vector<Mat> images = checkedPair(source, target);
    checkMatches(matches, images[0].size(), images[1].size());
    ProblemBuilder builder(images, std::vector<Mat>(), ScaleRule::EACH, params, progress);
    Report& report = builder.report();
    report.status = matches.status;
    report.message = matches.message;
    report.timings_ms.features = matches.timings_ms.features;
    report.timings_ms.homography = matches.timings_ms.homography;
    report.timings_ms.total = matches.timings_ms.features + matches.timings_ms.homography;
    builder.startFrom(startOfPair(workHomography(matches, builder.images())));
    builder.setMatches(toWork(matches, matchesUsedBy(params.method), builder.images()));
    builder.keepStraight();
    return builder.align();
}

} // namespace gcpw
} // namespace cv
