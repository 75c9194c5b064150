// Part of the GCPW module for OpenCV. Licence: Apache-2.0 (see LICENSE).
#include "opencv2/gcpw/aligner.hpp"

#include <algorithm>
#include <cmath>
#include <opencv2/core/utils/logger.hpp>
#include <opencv2/imgproc.hpp>
#include "imaging/photograph.hpp"
#include "model/inverse_map.hpp"
#include "pipeline/aligner_check.hpp"
#include "pipeline/image_graph.hpp"
#include "pipeline/match_gate.hpp"
#include "pipeline/pair_matcher.hpp"
#include "pipeline/result.hpp"

namespace cv
{
namespace gcpw
{

namespace
{

const int COMPARISONS = 3;   ///< of a pixel with other images: more repeat what these say
const int NO_REFERENCE = -2; ///< Params::referenceImage: all images move

/// What align() was given, in the module's own form, at the working resolution.
struct CanvasImages
{
    std::vector<Photograph> work;
    std::vector<Size> full_sizes;
    double scale = 1; ///< working pixels per given pixel, the same for all

    int count() const { return static_cast<int>(work.size()); }
    FrameScale frame() const
    {
        FrameScale result;
        result.x = result.y = scale;
        return result;
    }
};

std::vector<Mat> toMats(InputArrayOfArrays arrays)
{
    std::vector<Mat> mats;
    if (arrays.empty())
        return mats;
    if (arrays.isUMatVector())
    {
        std::vector<UMat> umats;
        arrays.getUMatVector(umats);
        for (const UMat& u : umats)
            mats.push_back(u.getMat(ACCESS_READ));
    }
    else
        arrays.getMatVector(mats);
    return mats;
}

CanvasImages gather(const std::vector<Point>& corners, InputArrayOfArrays image_array, InputArrayOfArrays mask_array,
                    double work_megapix)
{
    const std::vector<Mat> images = toMats(image_array);
    const std::vector<Mat> masks = toMats(mask_array);
    CV_CheckGE(images.size(), size_t(2), "gcpw: Aligner::align() takes two images or more");
    CV_CheckEQ(images.size(), corners.size(), "gcpw: Aligner::align() takes one corner for each image");
    if (!masks.empty())
        CV_CheckEQ(images.size(), masks.size(), "gcpw: Aligner::align() takes one mask for each image, or none");
    CanvasImages canvas;
    double largest = 1;
    for (const Mat& image : images)
        largest = std::max(largest, static_cast<double>(image.total()));
    canvas.scale = std::min(1.0, std::sqrt(work_megapix * 1e6 / largest));
    for (size_t i = 0; i < images.size(); ++i)
    {
        Photograph photograph = toPhotograph(images[i], format("%zu-th", i).c_str());
        if (!masks.empty() && !masks[i].empty())
        {
            CV_CheckTypeEQ(masks[i].type(), CV_8UC1, "gcpw: a mask is 8-bit with one channel");
            if (masks[i].size() != photograph.image.size())
                CV_Error(Error::StsUnmatchedSizes, format("gcpw: mask %zu has not the size of its image", i));
            hideOutside(photograph, masks[i]);
        }
        canvas.full_sizes.push_back(photograph.image.size());
        if (canvas.scale < 1)
        {
            const Size full = photograph.image.size();
            if (cvRound(full.width * canvas.scale) < 1 || cvRound(full.height * canvas.scale) < 1)
                CV_Error(Error::StsOutOfRange, format("gcpw: image %zu of %d x %d px vanishes at the working resolution; raise "
                                                      "Params::workMegapix, which is %g", i, full.width, full.height, work_megapix));
            // The scale itself, not the rounded sizes, says where pixels lie: all images keep one canvas.
            Photograph small;
            resize(photograph.image, small.image, Size(), canvas.scale, canvas.scale, INTER_AREA);
            if (!photograph.mask.empty())
            {
                resize(photograph.mask, small.mask, Size(), canvas.scale, canvas.scale, INTER_AREA);
                small.mask = small.mask > 254;
            }
            photograph = small;
        }
        canvas.work.push_back(photograph);
    }
    return canvas;
}

/// Corners as seen from one of them: where the caller's canvas has its origin must not matter.
std::vector<Point> fromOrigin(const std::vector<Point>& corners, Point origin)
{
    std::vector<Point> moved;
    for (const Point& corner : corners)
        moved.push_back(corner - origin);
    return moved;
}

Problem roughProblem(const CanvasImages& canvas, const std::vector<Point>& corners, const Params& params)
{
    Problem problem;
    problem.images.resize(canvas.work.size());
    for (size_t i = 0; i < canvas.work.size(); ++i)
    {
        // canvas_work = (corner + (rest + 0.5) / scale) * scale - 0.5
        const Point2d origin(corners[i].x * canvas.scale, corners[i].y * canvas.scale);
        problem.images[i].rough = MeshGrid(Lattice(canvas.work[i].image.size(), params.meshCols, params.meshRows), origin);
    }
    return problem;
}

std::vector<Overlap> overlapsOf(const CanvasImages& canvas, const Problem& problem, double period)
{
    std::vector<Point> corners;
    std::vector<Mat> masks;
    for (int i = 0; i < canvas.count(); ++i)
    {
        const Point2d corner = problem.images[i].rough.vertices()[0] + Point2d(0.5, 0.5);
        corners.emplace_back(cvRound(corner.x), cvRound(corner.y));
        const Photograph& photograph = canvas.work[i];
        masks.push_back(photograph.mask.empty() ? Mat(photograph.image.size(), CV_8U, Scalar(255)) : photograph.mask);
    }
    return withoutRepetition(findOverlaps(corners, masks, cvRound(period)), corners, masks, cvRound(period), COMPARISONS);
}

/// The keypoints that lie inside the mask, in working pixels.
Keypoints toWork(const KnownKeypoints& known, const Photograph& work, const FrameScale& scale)
{
    Keypoints result;
    Mat descriptors;
    known.descriptors.convertTo(descriptors, CV_8U);
    const Rect inside(Point(), work.image.size());
    const Rect2d around(-1, -1, inside.width + 1, inside.height + 1); // rounding stays within an int
    for (size_t i = 0; i < known.points.size(); ++i)
    {
        const Point2d p = scale.toWork(known.points[i]);
        if (!around.contains(p))
            continue;
        const Point pixel(cvRound(p.x), cvRound(p.y));
        if (!inside.contains(pixel) || (!work.mask.empty() && work.mask.at<uchar>(pixel) == 0))
            continue;
        result.points.push_back(p);
        result.descriptors.push_back(descriptors.row(static_cast<int>(i)));
    }
    return result;
}

class AlignerImpl : public Aligner
{
public:
    explicit AlignerImpl(const Params& params) : params_(params) { params_.check(); }

    const Params& params() const override { return params_; }

    Alignment align(const std::vector<Point>& corners, InputArrayOfArrays images, InputArrayOfArrays masks,
                    const std::vector<Correspondences>& correspondences, const Progress& progress,
                    const std::vector<KnownKeypoints>& keypoints) override
    {
        const int64 start = getTickCount();
        const CanvasImages canvas = gather(corners, images, masks, params_.workMegapix);
        checkAlignerInput(corners, canvas.full_sizes, correspondences, keypoints, params_);
        const auto go_on = [&](const char* stage, double share) { return !progress || progress(stage, share); };
        // That of the reference image if one is named, as alignPair() has it.
        const Point origin = corners[std::max(params_.referenceImage, 0)];
        Problem problem = roughProblem(canvas, fromOrigin(corners, origin), params_);
        const std::vector<Overlap> overlaps = overlapsOf(canvas, problem, params_.canvasPeriod * canvas.scale);
        if (params_.referenceImage != NO_REFERENCE)
            problem.images[params_.referenceImage >= 0 ? params_.referenceImage : mostCentral(canvas.count(), overlaps)].held = true;
        Report report;
        std::vector<ImageState> states = roughStates(problem);
        bool cancelled = false;
        if (overlaps.empty())
        {
            report.status = Status::ROUGH;
            report.message = "no two images overlap; the rough alignment was kept";
        }
        else
            cancelled = !matchAll(canvas, overlaps, correspondences, keypoints, go_on, problem, report);
        if (cancelled)
        {
            report.status = Status::CANCELLED;
            report.message = "cancelled; the rough alignment was kept";
        }
        else if (!overlaps.empty())
        {
            const int64 tick = getTickCount();
            for (int i = 0; i < canvas.count(); ++i)
                problem.images[i].pyramid = buildPyramid(canvas.work[i].image, canvas.work[i].mask, params_.pyramidLevels);
            refine(problem, params_, [&](double share) { return go_on("align", share); }, states, report);
            report.timings_ms.align = millisecondsSince(tick);
        }
        report.timings_ms.total = millisecondsSince(start);
        std::vector<Alignment::Image> result;
        const Scalar back(origin.x * canvas.scale, origin.y * canvas.scale);
        for (int i = 0; i < canvas.count(); ++i)
        {
            result.push_back(toImage(problem.images[i].rough, states[i], canvas.full_sizes[i]));
            result.back().mesh += back;
            result.back().rough += back;
        }
        return Alignment(result, Size2d(canvas.scale, canvas.scale), report);
    }

private:
    /// Fills in the problem's pairs. False if cancelled.
    template <typename GoOn>
    bool matchAll(const CanvasImages& canvas, const std::vector<Overlap>& overlaps,
                  const std::vector<Correspondences>& correspondences, const std::vector<KnownKeypoints>& keypoints,
                  GoOn go_on, Problem& problem, Report& report) const
    {
        const Recipe recipe = recipeOf(params_.method);
        std::vector<Features> features(canvas.work.size());
        int64 tick = getTickCount();
        for (int i = 0; correspondences.empty() && recipe.points && i < canvas.count(); ++i)
        {
            if (!go_on("features", static_cast<double>(i) / canvas.count()))
                return false;
            const Photograph& work = canvas.work[i];
            features[i] = i < static_cast<int>(keypoints.size()) && !keypoints[i].points.empty()
                              ? knownFeatures(work.image, work.mask, toWork(keypoints[i], work, canvas.frame()))
                              : detectFeatures(work.image, work.mask, work.image.size(), params_);
        }
        report.timings_ms.features = millisecondsSince(tick);
        tick = getTickCount();
        for (size_t k = 0; k < overlaps.size(); ++k)
        {
            if (!go_on("homography", static_cast<double>(k) / static_cast<double>(overlaps.size())))
                return false;
            ProblemPair pair;
            pair.a = overlaps[k].a;
            pair.b = overlaps[k].b;
            pair.shift_b = Point2d(overlaps[k].turns_b * params_.canvasPeriod * canvas.scale, 0);
            if (problem.images[pair.a].held)
            {
                std::swap(pair.a, pair.b); // samples lie in an image that moves
                pair.shift_b = -pair.shift_b;
            }
            const MeshGrid& a = problem.images[pair.a].rough;
            const MeshGrid& b = problem.images[pair.b].rough;
            pair.matches = correspondences.empty() ? matchPair(features[pair.a], features[pair.b], a, b, pair.shift_b, params_, recipe)
                                                   : given(correspondences, pair, canvas.frame(), a, b);
            problem.pairs.push_back(pair);
        }
        report.timings_ms.homography = millisecondsSince(tick);
        return true;
    }

    /// The caller's correspondences of a pair, gated.
    MatchSet given(const std::vector<Correspondences>& all, const ProblemPair& pair, const FrameScale& scale, const MeshGrid& a,
                   const MeshGrid& b) const
    {
        MatchSet matches;
        for (const Correspondences& item : all)
        {
            const bool straight = item.a == pair.a && item.b == pair.b;
            if (!straight && !(item.a == pair.b && item.b == pair.a))
                continue;
            for (size_t i = 0; i < item.points_a.size(); ++i)
            {
                PointMatch match;
                match.a = scale.toWork(straight ? item.points_a[i] : item.points_b[i]);
                match.b = scale.toWork(straight ? item.points_b[i] : item.points_a[i]);
                matches.points.push_back(match);
            }
        }
        GateSchedule schedule;
        schedule.similarity_weight = params_.similarityWeight;
        MeshGrid fitted = a;
        if (gateMatches(matches.points, fitted, a, b, pair.shift_b, schedule) == GateStatus::Unsolved)
            CV_LOG_WARNING(nullptr, "gcpw: no mesh fits the correspondences of images " << pair.a << " and " << pair.b
                                                                                        << "; they are left out");
        return matches;
    }

    Params params_;
};

} // namespace

Ptr<Aligner> Aligner::create(const Params& params)
{
    return makePtr<AlignerImpl>(params);
}

} // namespace gcpw
} // namespace cv
