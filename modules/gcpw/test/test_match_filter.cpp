// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#include "test_precomp.hpp"

#include "geometry/homography.hpp"
#include "registration/match_filter.hpp"
#include "scene.hpp"

namespace opencv_test { namespace {

using namespace cv::gcpw;

struct Filtered
{
    std::vector<PointMatch> before;
    std::vector<PointMatch> after;
    MeshGrid mesh;
    MatchFilterStatus status = MatchFilterStatus::Unsolved;
};

/// Filters matches of the default scene, from its rough homography.
Filtered filter(const Scene& scene, std::vector<PointMatch> matches)
{
    const SceneOptions options;
    MeshGrid rough(Lattice(options.source_size, 16, 16));
    for (Point2d& vertex : rough.vertices())
        vertex = applyHomography(options.rough, vertex);
    Filtered filtered;
    filtered.before = matches;
    filtered.mesh = rough;
    filtered.status =
        filterMatches(matches, filtered.mesh, rough, MeshGrid(Lattice(scene.target().size(), 16, 16)), Point2d(),
                      MatchFilterSchedule());
    filtered.after = matches;
    return filtered;
}

int trueOnes(const Scene& scene, const std::vector<PointMatch>& matches)
{
    int count = 0;
    for (const PointMatch& match : matches)
        count += cv::norm(scene.canvasAt(match.a) - match.b) < 3;
    return count;
}

TEST(Gcpw_MatchFilter, without_outliers_everything_is_kept)
{
    const Scene scene{SceneOptions()};
    const Filtered filtered = filter(scene, scene.pointMatches(300, 1, 0.3));
    ASSERT_EQ(filtered.status, MatchFilterStatus::Fitted);
    EXPECT_EQ(filtered.after.size(), 300u);
}

TEST(Gcpw_MatchFilter, true_matches_are_kept_and_outliers_dropped)
{
    const Scene scene{SceneOptions()};
    for (const double wrong_share : {0.1, 0.3, 0.5})
    {
        const Filtered filtered = filter(scene, scene.pointMatches(600, 2, 0.3, wrong_share));
        ASSERT_EQ(filtered.status, MatchFilterStatus::Fitted);
        const int before = trueOnes(scene, filtered.before);
        const int kept = trueOnes(scene, filtered.after);
        EXPECT_NEAR(before, 600 * (1 - wrong_share), 40);
        EXPECT_GE(kept, 0.97 * before) << wrong_share;
        EXPECT_LE(static_cast<int>(filtered.after.size()) - kept, 0.01 * (600 - before)) << wrong_share;
    }
}

TEST(Gcpw_MatchFilter, the_fitted_mesh_follows_the_true_matches)
{
    const Scene scene{SceneOptions()};
    const Filtered filtered = filter(scene, scene.pointMatches(600, 3, 0.3, 0.3));
    double sum = 0;
    for (const PointMatch& match : scene.pointMatches(200, 4))
        sum += cv::norm(filtered.mesh.warp(match.a) - match.b) / 200;
    EXPECT_LT(sum, 0.5);
}

TEST(Gcpw_MatchFilter, kept_matches_keep_their_order)
{
    const Scene scene{SceneOptions()};
    const Filtered filtered = filter(scene, scene.pointMatches(200, 5, 0.3, 0.4));
    size_t next = 0;
    for (const PointMatch& match : filtered.after)
    {
        while (next < filtered.before.size() && filtered.before[next].a != match.a)
            ++next;
        ASSERT_LT(next, filtered.before.size());
    }
}

TEST(Gcpw_MatchFilter, without_matches_the_mesh_stays)
{
    const Scene scene{SceneOptions()};
    const Filtered filtered = filter(scene, {});
    ASSERT_EQ(filtered.status, MatchFilterStatus::Fitted);
    EXPECT_TRUE(filtered.after.empty());
    MeshGrid rough(filtered.mesh.lattice());
    for (Point2d& vertex : rough.vertices())
        vertex = applyHomography(SceneOptions().rough, vertex);
    EXPECT_LT(maxVertexDistance(filtered.mesh, rough), 1e-6);
}

TEST(Gcpw_MatchFilter, a_fit_without_a_solution_verifies_no_match)
{
    const Scene scene{SceneOptions()};
    std::vector<PointMatch> matches = scene.pointMatches(50, 6);
    MeshGrid rough(Lattice(SceneOptions().source_size, 16, 16));
    rough.vertices()[40].x = std::numeric_limits<double>::quiet_NaN();
    MeshGrid mesh(rough.lattice());
    EXPECT_EQ(filterMatches(matches, mesh, rough, MeshGrid(rough.lattice()), Point2d(), MatchFilterSchedule()), MatchFilterStatus::Unsolved);
    EXPECT_TRUE(matches.empty());
    EXPECT_EQ(maxVertexDistance(mesh, MeshGrid(rough.lattice())), 0) << "the mesh is as it was";
}

TEST(Gcpw_MatchFilter, a_mesh_that_folds_is_not_handed_on)
{
    // Two columns of matches that change places: the mesh follows them only by folding between.
    const MeshGrid reference(Lattice(Size(320, 240), 16, 12));
    std::vector<PointMatch> matches;
    for (int y = 5; y < 240; y += 5)
        for (const double side : {-1.0, 1.0})
        {
            PointMatch match;
            match.a = Point2d(160 + 12 * side, y);
            match.b = Point2d(160 - 12 * side, y);
            matches.push_back(match);
        }
    MeshGrid mesh = reference;
    MatchFilterSchedule schedule;
    schedule.similarity_weight = 1e-3;
    EXPECT_EQ(filterMatches(matches, mesh, reference, reference, Point2d(), schedule), MatchFilterStatus::Folded);
    EXPECT_EQ(maxVertexDistance(mesh, reference), 0);
}

TEST(Gcpw_MatchFilter, matches_that_are_not_numbers_are_dropped)
{
    const Scene scene{SceneOptions()};
    std::vector<PointMatch> matches = scene.pointMatches(50, 6);
    matches[7].b.x = std::numeric_limits<double>::quiet_NaN();
    const Filtered filtered = filter(scene, matches);
    EXPECT_EQ(filtered.status, MatchFilterStatus::Fitted);
    EXPECT_EQ(filtered.after.size(), 49u);
}

}} // namespace
