// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#include "test_precomp.hpp"

#include "api/known_matches.hpp"
#include "api/problem_builder.hpp"
#include "opencv2/gcpw/aligner.hpp"
#include "scene.hpp"

namespace opencv_test
{
namespace
{

using namespace cv::gcpw;

const Point CORNER(66, -9); ///< of the source on the target's frame

/// A source and a target seen at half their size, and where the source roughly lies.
class Gcpw_ProblemBuilder : public ::testing::Test
{
protected:
    Gcpw_ProblemBuilder()
    {
        params.workMegapix = 0.0432; // 240 x 180 px
        params.referenceImage = 1;
    }

    static SceneOptions recolored()
    {
        SceneOptions options;
        options.rough = slightHomography(64);
        options.recolored = true;
        return options;
    }

    /// As Aligner has it, up to the matches.
    void buildOnCanvas(ProblemBuilder& builder) const
    {
        builder.startFrom(startOnCanvas(builder.images(), {CORNER, Point(0, 0)}, params));
        builder.findFeatures();
        builder.findMatches(matchesUsedBy(params.method));
    }

    PairMatches startAt(const Point& corner) const
    {
        PairMatches start;
        start.source_size = images[0].size();
        start.target_size = images[1].size();
        start.target_from_source = Matx33d(1, 0, corner.x, 0, 1, corner.y, 0, 0, 1);
        return start;
    }

    Alignment alignOnCanvas() const { return Aligner::create(params)->align({CORNER, Point(0, 0)}, images, noArray()); }

    const Scene scene{recolored()};
    const std::vector<Mat> images = {scene.source(), scene.target()};
    Params params;
    const Progress silent;
};

TEST_F(Gcpw_ProblemBuilder, a_pair_and_two_images_on_a_canvas_with_one_start_are_one_problem)
{
    ProblemBuilder pair(images, std::vector<Mat>(), ScaleRule::EACH, params, silent);
    pair.startFrom(startOfPair(workHomography(startAt(CORNER), pair.images())));
    pair.findFeatures();
    pair.findMatches(matchesUsedBy(params.method));
    ProblemBuilder canvas(images, std::vector<Mat>(), ScaleRule::COMMON, params, silent);
    buildOnCanvas(canvas);
    pair.align(); // with the pyramids the problem is complete
    canvas.align();
    const Problem& one = pair.problem();
    const Problem& other = canvas.problem();
    ASSERT_EQ(one.images.size(), other.images.size());
    for (size_t i = 0; i < one.images.size(); ++i)
    {
        EXPECT_EQ(one.images[i].fixed, other.images[i].fixed);
        EXPECT_EQ(one.images[i].rough.lattice().imageSize(), Size(240, 180));
        EXPECT_LT(maxVertexDistance(one.images[i].rough, other.images[i].rough), 1e-9);
        ASSERT_EQ(one.images[i].pyramid.size(), other.images[i].pyramid.size());
        for (size_t k = 0; k < one.images[i].pyramid.size(); ++k)
            EXPECT_EQ(cv::norm(one.images[i].pyramid[k].pixels, other.images[i].pyramid[k].pixels, NORM_INF), 0);
    }
    ASSERT_EQ(one.pairs.size(), 1u);
    ASSERT_EQ(other.pairs.size(), 1u);
    EXPECT_EQ(one.pairs[0].a, other.pairs[0].a);
    EXPECT_EQ(one.pairs[0].b, other.pairs[0].b);
    EXPECT_EQ(one.pairs[0].shift_b, other.pairs[0].shift_b);
    const MatchSet& matches = one.pairs[0].matches;
    ASSERT_GT(matches.points.size(), 20u);
    ASSERT_GT(matches.lines.size(), 0u);
    ASSERT_EQ(matches.points.size(), other.pairs[0].matches.points.size());
    ASSERT_EQ(matches.lines.size(), other.pairs[0].matches.lines.size());
    for (size_t i = 0; i < matches.points.size(); ++i)
    {
        EXPECT_LT(cv::norm(matches.points[i].a - other.pairs[0].matches.points[i].a), 1e-9);
        EXPECT_LT(cv::norm(matches.points[i].b - other.pairs[0].matches.points[i].b), 1e-9);
    }
}

TEST_F(Gcpw_ProblemBuilder, from_one_start_and_its_matches_both_calls_give_one_alignment)
{
    params.outsideWeight = 0; // alignPair() ignores it
    ProblemBuilder builder(images, std::vector<Mat>(), ScaleRule::COMMON, params, silent);
    buildOnCanvas(builder);
    PairMatches matches = startAt(CORNER);
    setMatches(builder.start().canvas_from_image[0], builder.problem().pairs[0].matches, builder.images(), matches);
    EXPECT_LT(cv::norm(matches.target_from_source - startAt(CORNER).target_from_source, NORM_INF), 1e-9);
    const Alignment pair = alignPair(images[0], images[1], matches, params);
    const Alignment canvas = alignOnCanvas();
    ASSERT_TRUE(pair.ok() && canvas.ok());
    ASSERT_GT(pair.report().max_displacement_px, 1) << "nothing to do";
    EXPECT_NEAR(pair.canvasScale().width, canvas.canvasScale().width, 1e-9);
    for (int i = 0; i < 2; ++i)
    {
        EXPECT_EQ(pair.image(i).work_size, canvas.image(i).work_size);
        EXPECT_LT(cv::norm(pair.image(i).mesh, canvas.image(i).mesh, NORM_INF), 1e-6);
        EXPECT_LT(cv::norm(pair.image(i).color, canvas.image(i).color, NORM_INF), 1e-6);
    }
    EXPECT_EQ(pair.report().pairs[0].points, canvas.report().pairs[0].points);
    EXPECT_EQ(pair.report().pairs[0].lines, canvas.report().pairs[0].lines);
}

TEST_F(Gcpw_ProblemBuilder, both_calls_look_for_features_at_their_own_resolution)
{
    params.method = Method::DFW;
    params.cornerTracking = 0; // corners are those of the working resolution
    int points[2][2]; // of the call, at the working resolution and above it
    for (int fine = 0; fine < 2; ++fine)
    {
        params.featureMegapix = fine == 0 ? params.workMegapix : 2;
        const Alignment pair = alignPair(images[0], images[1], params);
        const Alignment canvas = alignOnCanvas();
        ASSERT_TRUE(pair.ok() && canvas.ok());
        points[0][fine] = pair.report().pairs[0].points;
        points[1][fine] = canvas.report().pairs[0].points;
    }
    EXPECT_GT(points[0][1], 1.3 * points[0][0]) << "alignPair()";
    EXPECT_GT(points[1][1], 1.3 * points[1][0]) << "Aligner";
}

TEST_F(Gcpw_ProblemBuilder, steps_after_a_failure_do_nothing)
{
    ProblemBuilder apart(images, std::vector<Mat>(), ScaleRule::COMMON, params, silent);
    apart.startFrom(startOnCanvas(apart.images(), {Point(5000, 0), Point(0, 0)}, params));
    EXPECT_EQ(apart.report().status, Status::ROUGH);
    const std::string message = apart.report().message;
    apart.findFeatures();
    apart.findMatches(matchesUsedBy(params.method));
    const Alignment rough = apart.align();
    EXPECT_EQ(rough.imageCount(), 2);
    EXPECT_EQ(rough.report().message, message);
    EXPECT_TRUE(rough.report().levels.empty());

    const Progress stop = [](const std::string& stage, double) { return stage != "features"; };
    ProblemBuilder cancelled(images, std::vector<Mat>(), ScaleRule::EACH, params, stop);
    cancelled.findFeatures();
    cancelled.startFromHomography();
    cancelled.findMatches(matchesUsedBy(params.method));
    const Alignment none = cancelled.align();
    EXPECT_EQ(none.report().status, Status::CANCELLED);
    EXPECT_EQ(none.imageCount(), 0);
}

TEST_F(Gcpw_ProblemBuilder, a_pair_cancelled_after_its_homography_is_rough)
{
    const Progress stop = [](const std::string& stage, double share) { return stage != "homography" || share == 0; };
    const Alignment alignment = alignPair(images[0], images[1], params, stop);
    EXPECT_EQ(alignment.report().status, Status::CANCELLED);
    ASSERT_EQ(alignment.imageCount(), 2);
    EXPECT_EQ(cv::norm(alignment.image(0).mesh, alignment.image(0).rough, NORM_INF), 0);
}

TEST(Gcpw_WorkImage, images_on_one_canvas_have_one_scale_and_photographs_their_own)
{
    const std::vector<Size> sizes = {Size(1001, 700), Size(500, 333)};
    const std::vector<FrameScale> common = frameScales(sizes, 0.1, ScaleRule::COMMON);
    const std::vector<FrameScale> each = frameScales(sizes, 0.1, ScaleRule::EACH);
    const double factor = std::sqrt(1e5 / (1001.0 * 700));
    for (size_t i = 0; i < sizes.size(); ++i)
    {
        EXPECT_DOUBLE_EQ(common[i].x, factor);
        EXPECT_DOUBLE_EQ(common[i].y, factor);
        const Size work = cappedSize(sizes[i], 0.1);
        EXPECT_DOUBLE_EQ(each[i].x * sizes[i].width, work.width);
        EXPECT_DOUBLE_EQ(each[i].y * sizes[i].height, work.height);
    }
    EXPECT_EQ(frameScales(sizes, 1, ScaleRule::COMMON)[0].x, 1) << "nothing is scaled up";
}

} // namespace
} // namespace opencv_test
