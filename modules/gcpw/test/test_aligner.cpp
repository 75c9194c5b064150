// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#include "test_precomp.hpp"

#include <algorithm>
#include "opencv2/gcpw/aligner.hpp"
#include "overlap/outside_curves.hpp"
#include "registration/pair_matcher.hpp"
#include "registration/straight_lines.hpp"
#include "api/result.hpp"
#include "features_scene.hpp"
#include "scene.hpp"

namespace opencv_test { namespace {

using namespace cv::gcpw;

const int REFERENCE = 1;

/// A source that lies on the canvas up to a shift, a slight zoom and a smooth displacement.
SceneOptions sceneAt(double shift_px, uint64_t displacement_seed)
{
    SceneOptions options = smallScene();
    options.rough = slightHomography(shift_px);
    options.warp_seed = displacement_seed;
    return options;
}

Params withReference(int reference)
{
    Params params;
    params.outsideWeight = 0; // what alignPair() does not have
    params.referenceImage = reference;
    return params;
}

/// Mean error of image 0 if the target, whose frame the truth is in, has kept its place.
double errorOf(const Scene& scene, const Alignment& alignment, int image)
{
    return alignment.ok() ? scene.meanError(alignment.image(image).mesh) : 1e6;
}

TEST(Gcpw_Aligner, two_images_are_brought_together_and_the_reference_stays)
{
    const Scene scene(sceneAt(64, 1));
    const Ptr<Aligner> aligner = Aligner::create(withReference(REFERENCE));
    const std::vector<Mat> images = {scene.source(), scene.target()};
    const Alignment alignment = aligner->align({Point(66, -9), Point(0, 0)}, images, noArray());
    ASSERT_EQ(alignment.imageCount(), 2);
    EXPECT_LT(errorOf(scene, alignment, 0), 0.3);
    EXPECT_GT(scene.meanError(alignment.image(0).rough), 2) << "nothing to do";
    EXPECT_EQ(cv::norm(alignment.image(REFERENCE).mesh, alignment.image(REFERENCE).rough, NORM_INF), 0);
    EXPECT_EQ(alignment.report().folds, 0);
    for (int c = 0; c < 6; ++c)
        EXPECT_EQ(alignment.image(REFERENCE).color.ptr<float>(0)[c], c < 3 ? 1 : 0);
}

/// What alignPair() makes of a source and a target whose rough alignment is a shift: image 0 moves, image 1 is fixed.
Alignment pairResult(const Mat& source, const Mat& target, Point corner, const Params& params)
{
    Problem problem;
    problem.images.resize(2);
    problem.images[0].rough = MeshGrid(Lattice(source.size(), params.meshCols, params.meshRows), corner);
    problem.images[1].rough = MeshGrid(Lattice(target.size(), params.meshCols, params.meshRows));
    problem.images[1].fixed = true;
    problem.color_reference = 1;
    ProblemPair pair;
    pair.a = 0;
    pair.b = 1;
    pair.matches = matchPair(detectFeatures(source, Mat(), Size2d(1, 1), params), detectFeatures(target, Mat(), Size2d(1, 1), params),
                             problem.images[0].rough, problem.images[1].rough, Point2d(), params, matchesUsedBy(params.method));
    problem.pairs.push_back(pair);
    problem.images[0].pyramid = buildPyramid(source, Mat(), params.pyramidLevels);
    problem.images[1].pyramid = buildPyramid(target, Mat(), params.pyramidLevels);
    for (const Segment& line : findStraightLines(source, Mat()))
        problem.images[0].straight.push_back({line.start, line.end});
    const double near_border = 0.05 * std::hypot(source.cols, source.rows); // as ProblemBuilder has it
    for (const Segment& border : bordersOf(source.size()))
        for (const Curve& part : partsOutside({border.start, border.end}, problem.images[0].rough, {{&problem.images[1].rough, Point2d()}}, 4,
                                              near_border, near_border))
            problem.images[0].straight.push_back(part);
    std::vector<ImageState> states = roughStates(problem);
    Report report;
    refine(problem, params, StepCallback(), states, report);
    return Alignment({toImage(problem.images[0].rough, states[0], source.size()), toImage(problem.images[1].rough, states[1], target.size())},
                     Size2d(1, 1), report);
}

TEST(Gcpw_Aligner, two_images_with_one_fixed_are_what_the_pair_is)
{
    SceneOptions options = sceneAt(64, 1);
    options.recolored = true;
    const Scene scene(options);
    const auto keypointsAlone = [](int reference)
    {
        Params params = withReference(reference);
        params.cornerTracking = 0; // pairResult() matches keypoints
        return params;
    };
    const Alignment pair = pairResult(scene.source(), scene.target(), Point(66, -9), keypointsAlone(REFERENCE));
    ASSERT_TRUE(pair.ok());
    ASSERT_GT(pair.report().max_displacement_px, 2) << "nothing to do";
    const std::vector<Mat> two = {scene.source(), scene.target()};
    const std::vector<Mat> swapped = {scene.target(), scene.source()};
    const Alignment alone = Aligner::create(keypointsAlone(1))->align({Point(66, -9), Point(0, 0)}, two, noArray());
    const Alignment first_held = Aligner::create(keypointsAlone(0))->align({Point(0, 0), Point(66, -9)}, swapped, noArray());
    for (const Alignment::Image& image : {alone.image(0), first_held.image(1)})
    {
        EXPECT_LE(cv::norm(image.mesh, pair.image(0).mesh, NORM_INF), 1e-6);
        EXPECT_LE(cv::norm(image.color, pair.image(0).color, NORM_INF), 1e-6);
    }
}

TEST(Gcpw_Aligner, an_image_that_overlaps_none_keeps_its_place_and_hinders_none)
{
    const Scene scene(sceneAt(64, 1));
    const std::vector<Mat> images = {scene.source(), scene.target(), scene.source()};
    const Alignment alignment =
        Aligner::create(withReference(REFERENCE))->align({Point(66, -9), Point(0, 0), Point(5000, 0)}, images, noArray());
    EXPECT_LT(errorOf(scene, alignment, 0), 0.3);
    EXPECT_LE(cv::norm(alignment.image(2).mesh, alignment.image(2).rough, NORM_INF), 1e-6);
}

TEST(Gcpw_Aligner, three_images_meet_where_they_overlap)
{
    // Left and right of the target and of each other.
    const Scene right(sceneAt(80, 1));
    const Scene left(sceneAt(-60, 2));
    const std::vector<Mat> images = {right.source(), right.target(), left.source()};
    ASSERT_EQ(cv::norm(right.target(), left.target(), NORM_INF), 0) << "one canvas, one texture";
    const Alignment alignment = Aligner::create(withReference(REFERENCE))
                                    ->align({Point(82, -9), Point(0, 0), Point(-58, -9)}, images, noArray());
    EXPECT_LT(errorOf(right, alignment, 0), 0.3);
    EXPECT_LT(errorOf(left, alignment, 2), 0.3);
    EXPECT_EQ(alignment.report().pairs.size(), 3u);
    EXPECT_EQ(alignment.report().folds, 0);
}

TEST(Gcpw_Aligner, the_order_of_the_images_hardly_matters)
{
    const Scene right(sceneAt(80, 1));
    const Scene left(sceneAt(-60, 2));
    const std::vector<Mat> one = {right.source(), right.target(), left.source()};
    const std::vector<Mat> other = {left.source(), right.target(), right.source()};
    const Ptr<Aligner> aligner = Aligner::create(withReference(REFERENCE));
    const Alignment a = aligner->align({Point(82, -9), Point(0, 0), Point(-58, -9)}, one, noArray());
    const Alignment b = aligner->align({Point(-58, -9), Point(0, 0), Point(82, -9)}, other, noArray());
    ASSERT_TRUE(a.ok() && b.ok());
    Mat difference;
    cv::absdiff(a.image(0).mesh, b.image(2).mesh, difference);
    const Scalar mean = cv::mean(difference);
    EXPECT_LT(mean[0] + mean[1], 0.2);
}

TEST(Gcpw_Aligner, correspondences_are_taken_instead_of_looking_for_them_and_wrong_ones_left_out)
{
    const Scene scene(sceneAt(64, 1));
    Correspondences given;
    for (const PointMatch& match : scene.pointMatches(300, 3, 0.2, 0.3))
    {
        given.points_a.push_back(match.a);
        given.points_b.push_back(match.b);
    }
    Params params = withReference(REFERENCE);
    params.method = Method::CPW;
    const std::vector<Mat> images = {scene.source(), scene.target()};
    const Alignment alignment =
        Aligner::create(params)->align({Point(66, -9), Point(0, 0)}, images, noArray(), {given});
    EXPECT_LT(errorOf(scene, alignment, 0), 0.5);
    ASSERT_EQ(alignment.report().pairs.size(), 1u);
    EXPECT_GT(alignment.report().pairs[0].points, 180);
    EXPECT_LT(alignment.report().pairs[0].points, 225);
}

TEST(Gcpw_Aligner, images_apart_keep_their_places)
{
    const Scene scene(sceneAt(64, 1));
    const std::vector<Mat> images = {scene.source(), scene.target()};
    const Alignment alignment = Aligner::create()->align({Point(5000, 0), Point(0, 0)}, images, noArray());
    EXPECT_EQ(alignment.report().status, Status::ROUGH);
    EXPECT_FALSE(alignment.report().message.empty());
    for (int i = 0; i < 2; ++i)
        EXPECT_EQ(cv::norm(alignment.image(i).mesh, alignment.image(i).rough, NORM_INF), 0);
}

TEST(Gcpw_Aligner, what_the_masks_hide_does_not_matter)
{
    const Scene scene(sceneAt(64, 1));
    Mat mask(scene.source().size(), CV_8UC1, Scalar(255));
    mask(Rect(100, 80, 60, 50)).setTo(0);
    Alignment alignments[2];
    for (int i = 0; i < 2; ++i)
    {
        Mat source = scene.source().clone();
        source(Rect(100, 80, 60, 50)).setTo(Scalar(250 * i, 9, 130));
        const std::vector<Mat> images = {source, scene.target()};
        const std::vector<Mat> masks = {mask, Mat(scene.target().size(), CV_8UC1, Scalar(255))};
        alignments[i] = Aligner::create(withReference(REFERENCE))->align({Point(66, -9), Point(0, 0)}, images, masks);
        ASSERT_TRUE(alignments[i].ok());
    }
    EXPECT_EQ(cv::norm(alignments[0].image(0).mesh, alignments[1].image(0).mesh, NORM_INF), 0);
}

TEST(Gcpw_Aligner, one_thread_and_many_give_the_same_bits)
{
    const Scene scene(sceneAt(64, 1));
    const std::vector<Mat> images = {scene.source(), scene.target()};
    Params params = withReference(-2); // both move
    const int threads = getNumThreads();
    Alignment alignments[2];
    for (int i = 0; i < 2; ++i)
    {
        setNumThreads(i == 0 ? 2 : 1);
        alignments[i] = Aligner::create(params)->align({Point(66, -9), Point(0, 0)}, images, noArray());
    }
    setNumThreads(threads);
    ASSERT_TRUE(alignments[0].ok());
    for (int i = 0; i < 2; ++i)
    {
        EXPECT_EQ(cv::norm(alignments[0].image(i).mesh, alignments[1].image(i).mesh, NORM_INF), 0);
        EXPECT_EQ(cv::norm(alignments[0].image(i).color, alignments[1].image(i).color, NORM_INF), 0);
    }
}

TEST(Gcpw_Aligner, cancelling_at_any_step_keeps_the_rough_alignment)
{
    const Scene scene(sceneAt(64, 1));
    const std::vector<Mat> images = {scene.source(), scene.target()};
    const std::vector<Point> corners = {Point(66, -9), Point(0, 0)};
    Params params = withReference(REFERENCE);
    params.meshCols = params.meshRows = 8;
    std::vector<std::string> stages;
    double last = 0;
    const Alignment whole = Aligner::create(params)->align(corners, images, noArray(), std::vector<Correspondences>(),
                                                           [&](const std::string& stage, double share)
    {
        EXPECT_TRUE(0 <= share && share <= 1) << stage << " " << share;
        EXPECT_TRUE(stages.empty() || stages.back() != stage || share >= last) << stage << " goes back";
        stages.push_back(stage);
        last = share;
        return true;
    });
    ASSERT_TRUE(whole.ok());
    for (const char* stage : {"features", "homography", "align"})
        EXPECT_NE(std::find(stages.begin(), stages.end(), stage), stages.end()) << stage;
    for (size_t stop = 0; stop < stages.size(); ++stop)
    {
        size_t calls = 0;
        const Alignment alignment = Aligner::create(params)->align(corners, images, noArray(), std::vector<Correspondences>(),
                                                                   [&](const std::string&, double) { return calls++ < stop; });
        EXPECT_EQ(alignment.report().status, Status::CANCELLED) << stop;
        EXPECT_EQ(calls, stop + 1) << "asked again after the answer";
        for (int i = 0; i < 2; ++i)
            EXPECT_EQ(cv::norm(alignment.image(i).mesh, alignment.image(i).rough, NORM_INF), 0);
    }
}

TEST(Gcpw_Aligner, arguments_that_do_not_fit_are_refused_before_any_work)
{
    const Mat image(64, 64, CV_8UC3, Scalar::all(0));
    const std::vector<Mat> two = {image, image};
    const std::vector<Point> corners = {Point(0, 0), Point(10, 0)};
    const Ptr<Aligner> aligner = Aligner::create();
    EXPECT_THROW(aligner->align({Point(0, 0)}, two, noArray()), cv::Exception);
    EXPECT_THROW(aligner->align({Point(0, 0)}, std::vector<Mat>{image}, noArray()), cv::Exception);
    EXPECT_THROW(aligner->align(corners, std::vector<Mat>{image, Mat()}, noArray()), cv::Exception);
    EXPECT_THROW(aligner->align(corners, two, std::vector<Mat>{Mat(64, 64, CV_8UC1)}), cv::Exception);
    EXPECT_THROW(aligner->align(corners, two, std::vector<Mat>(2, Mat(64, 63, CV_8UC1))), cv::Exception);
    EXPECT_THROW(aligner->align(corners, two, std::vector<Mat>(2, Mat(64, 64, CV_32FC1))), cv::Exception);
    EXPECT_THROW(Aligner::create(withReference(2))->align(corners, two, noArray()), cv::Exception);
    Correspondences uneven;
    uneven.points_a.resize(3);
    EXPECT_THROW(aligner->align(corners, two, noArray(), {uneven}), cv::Exception);
    Correspondences foreign;
    foreign.a = 0;
    foreign.b = 7;
    EXPECT_THROW(aligner->align(corners, two, noArray(), {foreign}), cv::Exception);
    Params params;
    params.sampleStep = 0;
    EXPECT_THROW(Aligner::create(params), cv::Exception);
}

}} // namespace
