// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#include "test_precomp.hpp"

#include "registration/pair_matcher.hpp"
#include "features_scene.hpp"
#include "scene.hpp"

namespace opencv_test { namespace {

using namespace cv::gcpw;

const Size SIZE(300, 200);
const Point2d SHIFT(120, 10); ///< of the moving image against the fixed one

Segment segment(double x0, double y0, double x1, double y1)
{
    return {Point2d(x0, y0), Point2d(x1, y1)};
}

/// Matches segments alone: the moving image lies at SHIFT, so that the fixed image shows its part left of x = 179.5.
std::vector<LineMatch> linesOf(const std::vector<Segment>& moving, const std::vector<Segment>& fixed)
{
    const Lattice lattice(SIZE, 12, 8);
    Features a;
    Features b;
    a.segments = moving;
    b.segments = fixed;
    const Params params;
    return matchPair(a, b, MeshGrid(lattice, SHIFT), MeshGrid(lattice), Point2d(), params, matchesUsedBy(Method::GCPW)).lines;
}

TEST(Gcpw_PairMatcher, a_line_across_the_fixed_images_border_is_matched)
{
    // Its right part is beyond the border, where the fixed image shows nothing of it.
    const Segment across = segment(100, 50, 260, 60);
    const Segment target{across.start + SHIFT, across.at(75.0 / 160) + SHIFT};
    const std::vector<LineMatch> lines = linesOf({across}, {target});
    ASSERT_EQ(lines.size(), 1u);
    EXPECT_LT(cv::norm(lines[0].a.start - across.start), 1e-9);
    EXPECT_NEAR(lines[0].a.end.x, 179.5, 1.5) << "the part inside";
    EXPECT_LE(lines[0].a.end.x, 179.5);
    EXPECT_GT(lines[0].weight, 0.9);
}

TEST(Gcpw_PairMatcher, what_is_outside_points_nowhere)
{
    // Nearly all of it is outside. A slope of 45 degrees from its inner end is no target, whichever way it leads.
    const Segment outward = segment(179, 50, 290, 50);
    const Segment inward = segment(290, 50, 179, 50);
    const Point2d inner = Point2d(179, 50) + SHIFT;
    std::vector<Segment> slopes;
    for (const Point2d& far : {Point2d(-40, -40), Point2d(-40, 40)})
    {
        slopes.push_back({inner, inner + far});
        slopes.push_back({inner + far, inner});
    }
    EXPECT_TRUE(linesOf({outward}, slopes).empty());
    EXPECT_TRUE(linesOf({inward}, slopes).empty());
}

TEST(Gcpw_PairMatcher, both_kinds_of_features_heed_the_mask)
{
    const Scene scene(smallScene());
    Mat mask(scene.source().size(), CV_8UC1, Scalar(255));
    mask.colRange(0, 160).setTo(0);
    const Features detected = detectFeatures(scene.source(), mask, Size2d(1, 1), Params());
    const Features known = knownFeatures(scene.source(), mask, Size2d(1, 1), detected.keypoints);
    ASSERT_FALSE(detected.segments.empty());
    ASSERT_EQ(known.segments.size(), detected.segments.size());
    for (const Features& features : {detected, known})
        for (const Segment& s : features.segments)
            EXPECT_GE(std::min(s.start.x, s.end.x), 160);
    EXPECT_GT(detectFeatures(scene.source(), Mat(), Size2d(1, 1), Params()).segments.size(), detected.segments.size());
}

TEST(Gcpw_PairMatcher, matches_that_no_mesh_verifies_are_not_kept)
{
    const Scene scene(smallScene());
    const Features a = detectFeatures(scene.source(), Mat(), Size2d(1, 1), Params());
    const Features b = detectFeatures(scene.target(), Mat(), Size2d(1, 1), Params());
    MeshGrid rough(Lattice(scene.source().size(), 16, 16), Point2d(96, 0));
    const MeshGrid fixed(Lattice(scene.target().size(), 16, 16));
    const auto match = [&] { return matchPair(a, b, rough, fixed, Point2d(), Params(), matchesUsedBy(Method::GCPW)); };
    ASSERT_GT(match().points.size(), 20u);
    rough.vertices()[0].x = std::numeric_limits<double>::infinity();
    const MatchSet unverified = match();
    EXPECT_TRUE(unverified.points.empty());
    EXPECT_TRUE(unverified.lines.empty());
}

TEST(Gcpw_PairMatcher, guided_matching_looks_once_more_and_finds_more)
{
    const Scene scene((SceneOptions()));
    const Features a = detectFeatures(scene.source(), Mat(), Size2d(1, 1), Params());
    const Features b = detectFeatures(scene.target(), Mat(), Size2d(1, 1), Params());
    const MeshGrid rough(Lattice(scene.source().size(), 16, 16), Point2d(96, 0));
    const MeshGrid fixed(Lattice(scene.target().size(), 16, 16));
    Params params;
    const size_t guided = matchPair(a, b, rough, fixed, Point2d(), params, matchesUsedBy(Method::GCPW)).points.size();
    params.guidedMatching = 0;
    const size_t once = matchPair(a, b, rough, fixed, Point2d(), params, matchesUsedBy(Method::GCPW)).points.size();
    EXPECT_GT(once, 20u);
    EXPECT_GT(guided, once);
    EXPECT_EQ(Params::paper().guidedMatching, 0) << "the paper matches once";
}

}} // namespace
