// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#include "test_precomp.hpp"

#include <cmath>
#include "bent_mesh.hpp"
#include "optimization/best_candidate.hpp"
#include "optimization/decorrelation.hpp"
#include "scene.hpp"

namespace opencv_test { namespace {

using namespace cv::gcpw;

const int QUADS = 32; // a side: on the small images below a quad is smaller than a window

/// The same picture twice, the source's colours changed where asked; at the truth all meshes are undeformed.
Problem problemOf(Size size, double gain = 1, double bias = 0, bool textured = true)
{
    Mat target(size, CV_8UC3);
    Mat source(size, CV_8UC3);
    const Texture texture(5);
    for (int y = 0; y < size.height; ++y)
        for (int x = 0; x < size.width; ++x)
        {
            const Vec3d color = textured ? 255.0 * texture.at(Point2d(x, y)) : Vec3d::all(100);
            target.at<Vec3b>(y, x) = Vec3b(color);
            source.at<Vec3b>(y, x) = Vec3b(gain * color + Vec3d::all(bias));
        }
    Problem problem;
    problem.images.resize(2);
    problem.images[0].pyramid = buildPyramid(source, Mat(), 1);
    problem.images[1].pyramid = buildPyramid(target, Mat(), 1);
    for (ProblemImage& image : problem.images)
        image.rough = MeshGrid(Lattice(size, QUADS, QUADS));
    problem.pairs.resize(1);
    problem.pairs[0].a = 0;
    problem.pairs[0].b = 1;
    return problem;
}

/// All meshes rough, but that of the source moved.
std::vector<ImageState> shifted(const Problem& problem, double dx)
{
    std::vector<ImageState> states;
    for (const ProblemImage& image : problem.images)
        states.push_back({image.rough, ColorGrid(image.rough.lattice())});
    for (Point2d& vertex : states[0].mesh.vertices())
        vertex.x += dx;
    return states;
}

double missOf(const Problem& problem, double dx)
{
    return decorrelations(problem, shifted(problem, dx))[0].rms();
}

TEST(Gcpw_Decorrelation, is_zero_at_the_truth_and_grows_with_the_distance_from_it)
{
    const Problem problem = problemOf(Size(320, 240));
    EXPECT_NEAR(missOf(problem, 0), 0, 1e-6);
    EXPECT_GT(missOf(problem, 1), 0.01);
    EXPECT_GT(missOf(problem, 2), missOf(problem, 1));
    EXPECT_GT(missOf(problem, 4), missOf(problem, 2));
}

TEST(Gcpw_Decorrelation, sees_images_that_are_smaller_than_their_quads_would_need)
{
    const Problem problem = problemOf(Size(120, 90)); // quads of 4 x 3 px
    EXPECT_GT(missOf(problem, 2), 0.05);
    EXPECT_NEAR(missOf(problem, 2), missOf(problemOf(Size(320, 240)), 2), 0.5 * missOf(problem, 2));
}

TEST(Gcpw_Decorrelation, does_not_take_a_change_of_color_for_a_wrong_place)
{
    EXPECT_LT(missOf(problemOf(Size(320, 240), 0.7, 40), 0), 0.02);
}

TEST(Gcpw_Decorrelation, is_not_a_number_where_nothing_can_be_compared)
{
    EXPECT_TRUE(std::isnan(missOf(problemOf(Size(320, 240), 1, 0, false), 0))) << "no texture";
    EXPECT_TRUE(std::isnan(missOf(problemOf(Size(320, 240)), 1000))) << "no overlap";
}

TEST(Gcpw_Decorrelation, is_the_score_of_the_rendered_pair)
{
    SceneOptions options;
    options.noise = 4;
    const Scene scene(options);
    for (const Method method : {Method::CPW, Method::GCPW})
    {
        Params params;
        params.method = method;
        const Alignment alignment = alignPair(scene.source(), scene.target(), params);
        ASSERT_TRUE(alignment.ok());
        const double before = scorePair(renderPair(alignment.rough(), scene.source(), scene.target())).zncc;
        const double after = scorePair(renderPair(alignment, scene.source(), scene.target())).zncc;
        // Interpolated are the target's pixels here and the source's there: noise is smoothed in different places.
        EXPECT_NEAR(alignment.report().pairs[0].miss_before, before, 0.15 * before);
        EXPECT_NEAR(alignment.report().pairs[0].miss_after, after, 0.25 * after);
    }
}

TEST(Gcpw_Decorrelation, one_thread_and_many_give_the_same_bits)
{
    const Problem problem = problemOf(Size(320, 240));
    const int threads = getNumThreads();
    setNumThreads(4);
    const double many = missOf(problem, 1.3);
    setNumThreads(1);
    const double one = missOf(problem, 1.3);
    setNumThreads(threads);
    EXPECT_EQ(one, many);
}

Candidate bestOf(const Problem& problem, const std::vector<ImageState>& end, const std::vector<ImageState>& matches,
                 const std::vector<ImageState>& rough, double distortion_price = 0)
{
    return bestCandidate(problem, end, matches, rough, distortion_price).best;
}

TEST(Gcpw_BestCandidate, distortion_is_the_logarithm_of_a_stretch_and_nothing_for_a_similarity)
{
    Problem problem = problemOf(Size(320, 240));
    std::vector<ImageState> states = shifted(problem, 7);
    EXPECT_NEAR(distortionOf(problem, states), 0, 1e-6);
    for (Point2d& vertex : states[0].mesh.vertices())
        vertex = {0.8 * vertex.x - 0.3 * vertex.y, 0.3 * vertex.x + 0.8 * vertex.y};
    EXPECT_NEAR(distortionOf(problem, states), 0, 1e-6);
    for (Point2d& vertex : states[0].mesh.vertices())
        vertex.x *= 1.3;
    problem.images[1].fixed = true;
    EXPECT_NEAR(distortionOf(problem, states), std::log(1.3), 1e-6);
    problem.images[0].fixed = true;
    EXPECT_EQ(distortionOf(problem, states), 0) << "nothing moves";
}

TEST(Gcpw_BestCandidate, what_changes_shapes_must_gain_more)
{
    Problem problem = problemOf(Size(320, 240));
    const std::vector<ImageState> near_truth = shifted(problem, 1);
    const std::vector<ImageState> rough = shifted(problem, 2);
    for (Point2d& vertex : problem.images[0].rough.vertices())
        vertex.y *= 1.4; // all candidates are distorted against it
    EXPECT_EQ(bestOf(problem, near_truth, near_truth, rough, 0), Candidate::END);
    EXPECT_EQ(bestOf(problem, near_truth, near_truth, rough, 0.5), Candidate::END);
    EXPECT_EQ(bestOf(problem, near_truth, near_truth, rough, 5), Candidate::ROUGH);
}

TEST(Gcpw_BestCandidate, is_the_end_unless_an_earlier_one_correlates_better)
{
    for (const Size size : {Size(120, 90), Size(320, 240)})
    {
        const Problem problem = problemOf(size);
        const std::vector<ImageState> near_truth = shifted(problem, 0.5);
        const std::vector<ImageState> off = shifted(problem, 1.5);
        const std::vector<ImageState> far = shifted(problem, 3);
        EXPECT_EQ(bestOf(problem, near_truth, off, far), Candidate::END);
        EXPECT_EQ(bestOf(problem, far, near_truth, off), Candidate::MATCHES);
        EXPECT_EQ(bestOf(problem, off, far, near_truth), Candidate::ROUGH);
        EXPECT_EQ(bestOf(problem, off, off, off), Candidate::ROUGH) << "what gains nothing is not worth its bends";
        EXPECT_EQ(bestOf(problem, shifted(problem, 0), shifted(problem, 0), shifted(problem, 0)), Candidate::END)
            << "of two that are perfect none is better";
    }
}

TEST(Gcpw_BestCandidate, is_never_one_that_left_the_overlap_or_moved_out_of_proportion)
{
    Problem problem = problemOf(Size(320, 240));
    const std::vector<ImageState> truth = shifted(problem, 0);
    const std::vector<ImageState> near_truth = shifted(problem, 1);
    const std::vector<ImageState> rough = shifted(problem, 3);
    const std::vector<ImageState> away = shifted(problem, 500);
    problem.images[0].rough = rough[0].mesh;
    EXPECT_EQ(bestOf(problem, truth, near_truth, rough), Candidate::END);
    problem.images[0].rough = away[0].mesh; // so that the move alone says nothing
    EXPECT_EQ(bestOf(problem, away, near_truth, rough), Candidate::ROUGH) << "near_truth moved 499 px";
    problem.images[0].rough = MeshGrid(problem.images[0].rough.lattice(), Point2d(110, 0));
    EXPECT_EQ(bestOf(problem, truth, near_truth, rough), Candidate::END) << "0.275 of the diagonal";
    problem.images[0].rough = MeshGrid(problem.images[0].rough.lattice(), Point2d(130, 0));
    EXPECT_EQ(bestOf(problem, truth, near_truth, rough), Candidate::ROUGH) << "0.325 of the diagonal";
}

TEST(Gcpw_BestCandidate, is_the_end_where_the_rough_alignment_shows_nothing_to_compare)
{
    const Problem problem = problemOf(Size(320, 240), 1, 0, false);
    EXPECT_EQ(bestOf(problem, shifted(problem, 2), shifted(problem, 1), shifted(problem, 0)), Candidate::END);
}

/// Matches of a scene without any displacement, all of one region carried away together.
PairMatches misledMatches(const Scene& scene, const Matx33d& truth)
{
    PairMatches matches;
    matches.status = Status::OK;
    matches.source_size = scene.source().size();
    matches.target_size = scene.target().size();
    matches.target_from_source = truth;
    for (const PointMatch& match : scene.pointMatches(400, 3))
    {
        const bool carried_away = match.a.x > 60 && match.a.x < 140;
        matches.source_points.push_back(match.a);
        matches.target_points.push_back(match.b + (carried_away ? Point2d(9, 7) : Point2d()));
    }
    return matches;
}

TEST(Gcpw_BestCandidate, matches_that_mislead_leave_the_rough_alignment_with_colors_of_its_own)
{
    SceneOptions options = smallScene();
    options.displacement_px = 0;
    options.recolored = true;
    const Scene scene(options);
    Params params;
    params.geometricWeight = 1000; // pixels may not mend it
    for (const Method method : {Method::CPW, Method::GCPW})
    {
        params.method = method;
        const Alignment alignment = alignPair(scene.source(), scene.target(), misledMatches(scene, options.rough), params);
        // Here the homography is the truth: nothing is left to refine, and the status says OK.
        EXPECT_EQ(alignment.report().status, Status::OK);
        EXPECT_NE(alignment.report().message.find("already"), std::string::npos) << alignment.report().message;
        EXPECT_EQ(cv::norm(alignment.image(0).mesh, alignment.image(0).rough, NORM_INF), 0);
        EXPECT_EQ(alignment.report().pairs[0].miss_after, alignment.report().pairs[0].miss_before);
        EXPECT_EQ(alignment.report().max_displacement_px, 0);
        if (method != Method::GCPW)
            continue;
        const PairCanvas canvas = renderPair(alignment, scene.source(), scene.target());
        Mat inside;
        cv::bitwise_and(canvas.source_mask, canvas.target_mask, inside);
        cv::erode(inside, inside, Mat::ones(9, 9, CV_8U));
        const double raw = cv::norm(canvas.source, canvas.target, NORM_L1, inside);
        EXPECT_LT(cv::norm(canvas.source_corrected, canvas.target, NORM_L1, inside), 0.3 * raw);
    }
}

}} // namespace
