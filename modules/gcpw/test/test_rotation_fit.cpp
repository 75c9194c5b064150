// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#include "test_precomp.hpp"

#include "camera_scene.hpp"
#include "cameras/rotation_fit.hpp"
#include "seeded.hpp"

namespace opencv_test
{
namespace
{

using gcpw::Link;
using gcpw::TurningCameras;

/// Largest angle between the true and the found turn from one camera to the next, rad.
double worstTurn(const std::vector<Matx33d>& truth, const std::vector<Matx33d>& found)
{
    double worst = 0;
    for (size_t i = 1; i < truth.size(); ++i)
    {
        const Matx33d miss = (truth[i - 1].t() * truth[i]) * (found[i - 1].t() * found[i]).t();
        worst = std::max(worst, std::acos(std::min(1.0, 0.5 * (cv::trace(miss) - 1))));
    }
    return worst;
}

const double FOCAL = 500;

std::vector<Matx33d> strip(int count)
{
    std::vector<Matx33d> rotations;
    for (int i = 0; i < count; ++i)
        rotations.push_back(turnOf(0.35 * i, 0.06 * (i % 3), 0.03 * (i % 2)));
    return rotations;
}

TEST(Gcpw_RotationFit, exact_matches_give_the_true_cameras)
{
    const std::vector<Matx33d> truth = strip(5);
    TurningCameras found;
    ASSERT_TRUE(gcpw::fitTurningCameras(sizesOf(5), linksOfTurning(truth, FOCAL), found));
    EXPECT_NEAR(found.focal, FOCAL, 0.5);
    EXPECT_LT(worstTurn(truth, found.rotations), 1e-3);
    EXPECT_LT(found.cost, 1e-3);
}

TEST(Gcpw_RotationFit, a_third_of_wrong_matches_changes_little)
{
    const std::vector<Matx33d> truth = strip(5);
    std::vector<Link> links = linksOfTurning(truth, FOCAL);
    RNG rng = seeded(3);
    for (Link& link : links)
        for (size_t k = 0; k < link.points_a.size(); k += 3)
            link.points_b[k] += Point2f(rng.uniform(20.F, 60.F), rng.uniform(-60.F, 60.F));
    TurningCameras found;
    ASSERT_TRUE(gcpw::fitTurningCameras(sizesOf(5), links, found));
    EXPECT_NEAR(found.focal, FOCAL, 0.02 * FOCAL);
    EXPECT_LT(worstTurn(truth, found.rotations), 0.01);
}

TEST(Gcpw_RotationFit, the_same_links_give_the_same_bits)
{
    TurningCameras one;
    TurningCameras two;
    ASSERT_TRUE(gcpw::fitTurningCameras(sizesOf(4), linksOfTurning(strip(4), FOCAL), one));
    ASSERT_TRUE(gcpw::fitTurningCameras(sizesOf(4), linksOfTurning(strip(4), FOCAL), two));
    EXPECT_EQ(one.focal, two.focal);
    for (size_t i = 0; i < 4; ++i)
        EXPECT_EQ(cv::norm(one.rotations[i] - two.rotations[i]), 0);
}

TEST(Gcpw_RotationFit, links_that_do_not_connect_all_images_are_no_fit)
{
    std::vector<Link> links = linksOfTurning(strip(4), FOCAL);
    links.erase(std::remove_if(links.begin(), links.end(), [](const Link& link) { return link.b == 3; }), links.end());
    TurningCameras found;
    EXPECT_FALSE(gcpw::fitTurningCameras(sizesOf(4), links, found));
    EXPECT_FALSE(gcpw::fitTurningCameras(sizesOf(4), std::vector<Link>(), found));
}

} // namespace
} // namespace opencv_test
