// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#include "api/problem_builder.hpp"

#include <algorithm>
#include <cmath>
#include <opencv2/core/utils/logger.hpp>
#include "api/known_matches.hpp"
#include "api/result.hpp"
#include "geometry/homography.hpp"
#include "overlap/outside_curves.hpp"
#include "registration/match_filter.hpp"
#include "registration/straight_lines.hpp"

namespace cv
{
namespace gcpw
{

namespace
{

const double BORDER_STEP = 4;      ///< px between the places where it is looked whether another image shows a border
const double LEAST_BORDER = 0.05;  ///< of the diagonal: a shorter piece of a border is not seen to bend
const double BORDER_MARGIN = 0.05; ///< of the diagonal: what is covered by no more may come to light as meshes move

const double COARSE_MEGAPIX =
    0.15;                    ///< where keypoints only have to find a homography: accurate to a px of the working image
const int SURE_MATCHES = 30; ///< inliers of such a homography below which it is looked for with all keypoints

std::vector<Curve> toCurves(const std::vector<Segment>& segments)
{
    std::vector<Curve> curves;
    for (const Segment& segment : segments)
        curves.push_back({segment.start, segment.end});
    return curves;
}

std::vector<Photograph> toPhotographs(const std::vector<Mat>& images, const std::vector<Mat>& masks)
{
    std::vector<Photograph> photographs;
    for (size_t i = 0; i < images.size(); ++i)
    {
        photographs.push_back(toPhotograph(images[i], format("%zu-th", i).c_str()));
        if (!masks.empty() && !masks[i].empty())
            hideOutside(photographs.back(), masks[i]);
    }
    return photographs;
}

/// The lattice of every image carried through its homography.
std::vector<ProblemImage> roughImages(const std::vector<WorkImage>& images, const RoughStart& start,
                                      const Params& params)
{
    std::vector<ProblemImage> result(images.size());
    for (size_t i = 0; i < images.size(); ++i)
    {
        result[i].rough = MeshGrid(Lattice(images[i].photograph.image.size(), params.meshCols, params.meshRows));
        for (Point2d& vertex : result[i].rough.vertices())
            vertex = applyHomography(start.canvas_from_image[i], vertex);
        result[i].fixed = static_cast<int>(i) == start.fixed;
    }
    return result;
}

} // namespace

ProblemBuilder::ProblemBuilder(const std::vector<Mat>& images, const std::vector<Mat>& masks, ScaleRule rule,
                               const Params& params, const Progress& progress)
    : params_(params), progress_(progress), begin_(getTickCount()), full_(toPhotographs(images, masks)),
      images_(toWork(full_, params.workMegapix, rule)), features_(images.size())
{
}

bool ProblemBuilder::goOn(const char* stage, double share)
{
    if (!progress_ || progress_(stage, share))
        return true;
    report_.status = Status::CANCELLED;
    report_.message = problem_.images.empty() ? "cancelled before a rough alignment was found"
                                              : "cancelled; the rough alignment was kept";
    return false;
}

void ProblemBuilder::findFeatures(const std::vector<KnownKeypoints>& known)
{
    const int64 tick = getTickCount();
    for (size_t i = 0; !failed() && i < full_.size(); ++i)
    {
        if (!goOn("features", static_cast<double>(i) / static_cast<double>(full_.size())))
            break;
        Features& features = features_[i];
        if (i < known.size() && !known[i].points.empty())
            features.keypoints = toWork(known[i], images_[i]);
        else if (params_.cornerTracking == 0)
            features.keypoints = findKeypoints(i, params_.featureMegapix);
        else if (problem_.images.empty()) // the start is to be found
            features.keypoints = findKeypoints(i, std::min(COARSE_MEGAPIX, params_.featureMegapix));
        const Photograph& work = images_[i].photograph;
        if (params_.cornerTracking != 0)
            prepareCorners(work.image, work.mask, params_, features);
        const double megapix = params_.cornerTracking != 0 ? std::min(params_.workMegapix, params_.featureMegapix)
                                                           : params_.featureMegapix;
        const Photograph photograph = shownAt(i, megapix);
        features.segments = segmentsOf(photograph.image, photograph.mask, toReference(i, photograph));
    }
    report_.timings_ms.features += millisecondsSince(tick);
}

/// An image scaled down for features.
Photograph ProblemBuilder::shownAt(size_t i, double megapix) const
{
    // The working copy is what matters; it is also the quicker to scale down.
    const Photograph& work = images_[i].photograph;
    const Photograph& photograph = 1e-6 * static_cast<double>(work.image.total()) >= megapix ? work : full_[i];
    const Size size = photograph.image.size();
    return resized(photograph, FrameScale(cappedSize(size, megapix), size));
}

Size2d ProblemBuilder::toReference(size_t i, const Photograph& shown) const
{
    const FrameScale& scale = images_[i].scale;
    return {scale.x * full_[i].image.cols / shown.image.cols, scale.y * full_[i].image.rows / shown.image.rows};
}

Keypoints ProblemBuilder::findKeypoints(size_t i, double megapix) const
{
    const Photograph photograph = shownAt(i, megapix);
    return keypointsOf(photograph.image, photograph.mask, toReference(i, photograph), params_);
}

RoughAlignment ProblemBuilder::alignFeatures() const
{
    return alignRoughly(features_[0].keypoints, features_[1].keypoints, features_[0].segments, features_[1].segments,
                        images_[0].photograph.image.size());
}

void ProblemBuilder::keepStraight(const std::vector<KnownLines>& known)
{
    const int64 tick = getTickCount();
    for (size_t i = 0; !failed() && i < problem_.images.size(); ++i)
    {
        ProblemImage& image = problem_.images[i];
        if (image.fixed || params_.straightnessWeight == 0)
            continue;
        std::vector<Curve> borders;
        if (!known.empty())
        {
            image.straight = toWork(known[i].curves, images_[i]);
            borders = toWork(known[i].borders, images_[i]);
        }
        else
        {
            const Photograph& photograph = images_[i].photograph;
            image.straight = toCurves(findStraightLines(photograph.image, photograph.mask));
            if (photograph.mask.empty()) // else what is seen ends elsewhere
                borders = toCurves(bordersOf(photograph.image.size()));
        }
        keepBorders(borders, static_cast<int>(i));
    }
    report_.timings_ms.features += millisecondsSince(tick);
}

/// Adds what of the borders is a border of the picture as well.
void ProblemBuilder::keepBorders(const std::vector<Curve>& borders, int i)
{
    ProblemImage& image = problem_.images[i];
    const Size size = image.rough.lattice().imageSize();
    const double diagonal = std::hypot(size.width, size.height);
    const std::vector<Neighbour> neighbours = neighboursOf(i);
    for (const Curve& border : borders)
        for (const Curve& part : partsOutside(border, image.rough, neighbours, BORDER_STEP, LEAST_BORDER * diagonal,
                                              BORDER_MARGIN * diagonal))
            image.straight.push_back(part);
}

void ProblemBuilder::keepOutside()
{
    for (size_t i = 0; !failed() && params_.outsideWeight > 0 && i < problem_.images.size(); ++i)
        if (!problem_.images[i].fixed)
            problem_.images[i].outside = distanceOutside(problem_.images[i].rough, neighboursOf(static_cast<int>(i)));
}

void ProblemBuilder::startFromHomography()
{
    CV_DbgAssert(images_.size() == 2);
    if (failed() || !goOn("homography", 0))
        return;
    const int64 tick = getTickCount();
    homography_steps_ = 1;
    RoughAlignment rough = alignFeatures();
    if (params_.cornerTracking != 0 && rough.inliers < SURE_MATCHES)
    {
        for (size_t i = 0; i < images_.size(); ++i)
            features_[i].keypoints = findKeypoints(i, params_.featureMegapix);
        rough = alignFeatures();
    }
    if (rough.found)
        startFrom(startOfPair(rough.b_from_a));
    else
    {
        report_.status = Status::NO_ALIGNMENT;
        report_.message =
            format("no alignment: %d keypoint matches, of which %d agree on a plausible homography; %d are needed",
                   rough.tentative, rough.inliers, MIN_MATCHES);
    }
    report_.timings_ms.homography += millisecondsSince(tick);
}

void ProblemBuilder::startFrom(const RoughStart& start)
{
    if (failed())
        return;
    start_ = start;
    problem_.images = roughImages(images_, start_, params_);
    problem_.pairs = start_.pairs;
    problem_.color_reference = start_.color_reference;
    if (problem_.pairs.empty())
    {
        report_.status = Status::ROUGH;
        report_.message = "no two images overlap; the rough alignment was kept";
    }
}

std::vector<Neighbour> ProblemBuilder::neighboursOf(int image) const
{
    std::vector<Neighbour> neighbours;
    for (const ProblemPair& pair : problem_.pairs)
        if (pair.a == image)
            neighbours.push_back({&problem_.images[pair.b].rough, pair.shift_b});
        else if (pair.b == image)
            neighbours.push_back({&problem_.images[pair.a].rough, -pair.shift_b});
    return neighbours;
}

void ProblemBuilder::findMatches(MatchKinds kinds, const std::vector<Correspondences>& known)
{
    const int64 tick = getTickCount();
    const double steps = homography_steps_ + static_cast<double>(problem_.pairs.size());
    for (size_t k = 0; !failed() && k < problem_.pairs.size(); ++k)
    {
        if (!goOn("homography", (homography_steps_ + static_cast<double>(k)) / steps))
            break;
        ProblemPair& pair = problem_.pairs[k];
        pair.matches = known.empty() ? matchPair(features_[pair.a], features_[pair.b], problem_.images[pair.a].rough,
                                                 problem_.images[pair.b].rough, pair.shift_b, params_, kinds)
                                     : verified(known, pair);
    }
    report_.timings_ms.homography += millisecondsSince(tick);
}

void ProblemBuilder::setMatches(const MatchSet& matches)
{
    if (!failed())
        problem_.pairs.front().matches = matches;
}

MatchSet ProblemBuilder::verified(const std::vector<Correspondences>& known, const ProblemPair& pair) const
{
    MatchSet matches;
    matches.points = toWork(known, pair.a, pair.b, images_);
    MatchFilterSchedule schedule;
    schedule.similarity_weight = std::max(params_.similarityWeight, schedule.similarity_weight);
    const MeshGrid& a = problem_.images[pair.a].rough;
    MeshGrid fitted = a;
    if (filterMatches(matches.points, fitted, a, problem_.images[pair.b].rough, pair.shift_b, schedule) ==
        MatchFilterStatus::Unsolved)
        CV_LOG_WARNING(nullptr, "gcpw: no mesh fits the correspondences of images " << pair.a << " and " << pair.b
                                                                                    << "; they are left out");
    return matches;
}

Alignment ProblemBuilder::align()
{
    std::vector<ImageState> states = roughStates(problem_);
    if (!failed())
    {
        const int64 tick = getTickCount();
        full_.clear(); // nothing looks at these any more, and the estimation takes more than they do
        features_.clear();
        for (size_t i = 0; i < images_.size(); ++i)
        {
            problem_.images[i].pyramid =
                buildPyramid(images_[i].photograph.image, images_[i].photograph.mask, params_.pyramidLevels);
            images_[i].photograph = Photograph();
        }
        refine(
            problem_, params_, [&](double share) { return !progress_ || progress_("align", share); }, states, report_);
        report_.timings_ms.align = millisecondsSince(tick);
    }
    report_.timings_ms.total += millisecondsSince(begin_);
    std::vector<Alignment::Image> result;
    for (size_t i = 0; i < states.size(); ++i)
    {
        result.push_back(toImage(problem_.images[i].rough, states[i], images_[i].full_size));
        result.back().mesh += Scalar(start_.origin.x, start_.origin.y);
        result.back().rough += Scalar(start_.origin.x, start_.origin.y);
    }
    // The canvas is the frame of the last image of a pair, and of all images where they share one scale.
    const FrameScale& scale = images_.back().scale;
    return Alignment(result, result.empty() ? Size2d(1, 1) : Size2d(scale.x, scale.y), report_);
}

} // namespace gcpw
} // namespace cv
