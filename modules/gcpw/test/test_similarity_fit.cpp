// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#include "test_precomp.hpp"

#include "camera_scene.hpp"
#include "cameras/similarity_fit.hpp"
#include "seeded.hpp"

namespace opencv_test
{
namespace
{

using gcpw::Link;

Matx33d similarity(double scale, double angle, double x, double y)
{
    const double c = scale * std::cos(angle);
    const double s = scale * std::sin(angle);
    return {c, -s, x, s, c, y, 0, 0, 1};
}

/// Canvas from image: a row of photographs, each turned, zoomed and shifted.
std::vector<Matx33d> row()
{
    return {similarity(1, 0, 0, 0), similarity(1.1, 0.15, 260, -30), similarity(0.9, -0.2, 560, 90),
            similarity(1.05, 0.4, 900, -60)};
}

std::vector<Link> linksOfRow(const std::vector<Matx33d>& truth)
{
    return linksBy(truth.size(), [&](int a, int b) { return truth[b].inv() * truth[a]; });
}

/// Largest distance of an image's corners from where they are in truth, in a frame common to both: that of the first image.
double worstCorner(const std::vector<Matx33d>& truth, const std::vector<Matx33d>& found)
{
    double worst = 0;
    for (size_t i = 0; i < truth.size(); ++i)
        for (const Vec3d& corner : {Vec3d(0, 0, 1), Vec3d(SHOT.width, 0, 1), Vec3d(0, SHOT.height, 1)})
            worst = std::max(worst, cv::norm(truth[0].inv() * truth[i] * corner - found[0].inv() * found[i] * corner));
    return worst;
}

TEST(Gcpw_SimilarityFit, exact_matches_give_the_true_places)
{
    std::vector<Matx33d> found;
    ASSERT_TRUE(gcpw::fitSimilarities(sizesOf(4), linksOfRow(row()), found));
    EXPECT_LT(worstCorner(row(), found), 0.05);
}

TEST(Gcpw_SimilarityFit, scales_are_one_in_the_geometric_mean)
{
    std::vector<Matx33d> found;
    ASSERT_TRUE(gcpw::fitSimilarities(sizesOf(4), linksOfRow(row()), found));
    double log_scale = 0;
    for (const Matx33d& place : found)
        log_scale += 0.5 * std::log(determinant(place));
    EXPECT_NEAR(log_scale, 0, 1e-6);
}

TEST(Gcpw_SimilarityFit, a_third_of_wrong_matches_changes_little)
{
    std::vector<Link> links = linksOfRow(row());
    RNG rng = seeded(5);
    for (Link& link : links)
        for (size_t k = 0; k < link.points_a.size(); k += 3)
            link.points_b[k] += Point2f(rng.uniform(20.F, 60.F), rng.uniform(-60.F, 60.F));
    std::vector<Matx33d> found;
    ASSERT_TRUE(gcpw::fitSimilarities(sizesOf(4), links, found));
    EXPECT_LT(worstCorner(row(), found), 6);
}

TEST(Gcpw_SimilarityFit, links_that_do_not_connect_all_images_are_no_fit)
{
    std::vector<Link> links = linksOfRow(row());
    links.erase(std::remove_if(links.begin(), links.end(), [](const Link& link) { return link.b == 3; }), links.end());
    std::vector<Matx33d> found;
    EXPECT_FALSE(gcpw::fitSimilarities(sizesOf(4), links, found));
}

} // namespace
} // namespace opencv_test
