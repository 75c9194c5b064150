// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#include "test_precomp.hpp"

#include "camera_scene.hpp"
#include "cameras/camera_search.hpp"
#include "seeded.hpp"
#include "stitching/affine_warper.hpp"
#include "stitching/warper_names.hpp"

namespace opencv_test
{
namespace
{

using gcpw::CameraChoice;
using gcpw::CameraModel;
using gcpw::LinkedImages;

Ptr<cv::detail::RotationWarper> makeWarper(const std::string& name, float scale)
{
    return gcpw::trueWarper(gcpw::warperOfName(name)->create(scale));
}

CameraChoice found(const LinkedImages& images)
{
    return gcpw::searchCameras(images, 1, makeWarper, std::string());
}

std::vector<Matx33d> strip()
{
    return {turnOf(-0.6), turnOf(-0.2, 0.02), turnOf(0.2, -0.02), turnOf(0.6)};
}

bool says(const CameraChoice& choice, const std::string& words)
{
    for (const std::string& decision : choice.decisions)
        if (decision.find(words) != std::string::npos)
            return true;
    return false;
}

TEST(Gcpw_CameraSearch, cameras_that_turn_are_found_with_their_own_focal_lengths)
{
    const CameraChoice choice = found(linkedBy(4, linksOfTurning(strip(), 600)));
    EXPECT_EQ(choice.component, (std::vector<int>{0, 1, 2, 3}));
    ASSERT_EQ(choice.cameras.size(), size_t(4));
    EXPECT_EQ(choice.model, CameraModel::TURNING);
    for (const cv::detail::CameraParams& camera : choice.cameras)
        EXPECT_NEAR(camera.focal, 600, 12);
    EXPECT_TRUE(says(choice, "focal length of its own")) << "the choice is not told";
}

TEST(Gcpw_CameraSearch, where_single_focal_lengths_explode_all_get_one)
{
    // Few matches along a line leave the focal length of the last image open, and noise runs away with it.
    std::vector<gcpw::Link> links = linksOfTurning(strip(), 600);
    RNG rng = seeded(2);
    for (gcpw::Link& link : links)
        if (link.b == 3)
        {
            link.points_a.resize(24);
            link.points_b.resize(24);
            for (Point2f& p : link.points_b)
                p = Point2f(0.25F * p.x, 0.25F * p.y) + Point2f(rng.uniform(-2.F, 2.F), rng.uniform(-2.F, 2.F));
        }
    const CameraChoice choice = found(linkedBy(4, links));
    ASSERT_FALSE(choice.cameras.empty());
    EXPECT_NE(choice.model, CameraModel::TURNING);
    EXPECT_TRUE(says(choice, "were not taken"));
}

/// Links of narrow views of which noise hides the focal length: homographies of any of them fit as well.
LinkedImages narrowViews(double focal, uint64_t seed, double noise_px)
{
    std::vector<gcpw::Link> links = linksOfTurning({turnOf(-0.06), turnOf(0), turnOf(0.05, 0.01), turnOf(0.1)}, focal);
    RNG rng = seeded(seed);
    for (gcpw::Link& link : links)
        for (Point2f& p : link.points_b)
            p += Point2f(static_cast<float>(rng.gaussian(noise_px)), static_cast<float>(rng.gaussian(noise_px)));
    return linkedBy(4, links);
}

TEST(Gcpw_CameraSearch, noted_focal_lengths_are_a_start_also_where_a_file_notes_none)
{
    LinkedImages images = linkedBy(4, linksOfTurning(strip(), 600));
    std::vector<cv::detail::CameraParams> cameras;
    EXPECT_FALSE(gcpw::fitCameras(images, 1, CameraModel::TURNING_NOTED, cameras)) << "none is noted";
    images.focals = {580, 0, 620, 640};
    ASSERT_TRUE(gcpw::fitCameras(images, 1, CameraModel::TURNING_NOTED, cameras));
    for (const cv::detail::CameraParams& camera : cameras)
        EXPECT_NEAR(camera.focal, 600, 12) << "the matches have the last word";
    images.focals = {580, 0, 0, 640};
    const LinkedImages part = gcpw::subset(images, {1, 3});
    EXPECT_EQ(part.focals, (std::vector<double>{0, 640}));
    EXPECT_TRUE(gcpw::notesFocal(part));
    EXPECT_FALSE(gcpw::notesFocal(gcpw::subset(images, {1, 2})));
}

TEST(Gcpw_CameraSearch, noted_focal_lengths_are_tried_only_where_the_matches_leave_room_and_replace_nothing)
{
    const std::string noted = "the focal lengths that the files note";
    LinkedImages clear = linkedBy(4, linksOfTurning(strip(), 600));
    clear.focals = {900, 900, 900, 900};
    EXPECT_FALSE(says(found(clear), noted));
    EXPECT_NEAR(found(clear).cameras[0].focal, 600, 12) << "what a file notes wrongly has no effect";
    LinkedImages noisy = narrowViews(4000, 1, 3);
    const CameraChoice without = found(noisy);
    EXPECT_FALSE(says(without, noted));
    noisy.focals = {4000, 0, 4000, 4000};
    const CameraChoice with = found(noisy);
    EXPECT_TRUE(says(with, noted)) << "not tried, or not told";
    EXPECT_EQ(with.cameras[0].focal, without.cameras[0].focal) << "it fits the matches no better";
}

/// Of a camera that moves along a wall by so many pixels from shot to shot.
std::vector<gcpw::Link> linksAlongAWall(int count, double step_px)
{
    return linksBy(count, [step_px](int a, int b) { return Matx33d(1, 0, -step_px * (b - a), 0, 1, 0, 0, 0, 1); });
}

TEST(Gcpw_CameraSearch, photographs_of_a_plane_far_apart_are_laid_beside_each_other)
{
    // A turning camera would see more than a circle.
    const std::vector<gcpw::Link> links = linksAlongAWall(12, 400);
    const CameraChoice choice = found(linkedBy(12, links));
    ASSERT_EQ(choice.cameras.size(), size_t(12));
    const Ptr<cv::detail::RotationWarper> warper = makeWarper(choice.projection, gcpw::medianFocal(choice.cameras));
    const gcpw::PictureShape shape = gcpw::shapeOfPicture(choice.cameras, sizesOf(12), *warper, 0);
    EXPECT_EQ(shape.fault, "");
    EXPECT_LT(shape.area, 1);
}

TEST(Gcpw_CameraSearch, photographs_of_a_plane_are_not_bent_onto_a_sphere)
{
    // Near enough to each other that turning cameras fit them somehow.
    const std::vector<gcpw::Link> links = linksAlongAWall(4, 250);
    const CameraChoice choice = found(linkedBy(4, links));
    ASSERT_EQ(choice.cameras.size(), size_t(4));
    const Ptr<cv::detail::RotationWarper> warper = makeWarper(choice.projection, gcpw::medianFocal(choice.cameras));
    for (const double miss : gcpw::missesOf(choice.cameras, links, *warper, 0))
        EXPECT_LT(miss, 0.004 * SHOT.width);
}

TEST(Gcpw_CameraSearch, a_later_model_is_taken_only_if_it_is_nearer_in_most_links_and_in_half_of_them)
{
    const auto misses = [](double half, double most)
    {
        gcpw::Misses result;
        result.half = half;
        result.most = most;
        return result;
    };
    EXPECT_TRUE(gcpw::isTruer(misses(0.002, 0.004), misses(0.006, 0.01)));
    EXPECT_FALSE(gcpw::isTruer(misses(0.002, 0.008), misses(0.006, 0.01))) << "not clearly nearer";
    // Hand-held, and the last photograph from another place: a plane follows its two links with a zoom, and misses the others.
    EXPECT_FALSE(gcpw::isTruer(misses(0.0044, 0.0083), misses(0.0026, 0.0142))) << "one photograph decides for all";
}

TEST(Gcpw_CameraSearch, an_image_without_links_is_left_out)
{
    const CameraChoice choice = found(linkedBy(5, linksOfTurning(strip(), 600)));
    EXPECT_EQ(choice.component, (std::vector<int>{0, 1, 2, 3}));
    EXPECT_EQ(choice.cameras.size(), size_t(4));
}

TEST(Gcpw_CameraSearch, images_without_any_link_have_no_cameras_and_a_reason)
{
    const CameraChoice choice = found(linkedBy(3, std::vector<gcpw::Link>()));
    EXPECT_TRUE(choice.cameras.empty());
    EXPECT_TRUE(choice.component.empty());
    ASSERT_FALSE(choice.decisions.empty());
    EXPECT_NE(choice.decisions.back().find("match"), std::string::npos);
}

TEST(Gcpw_CameraSearch, links_that_contradict_each_other_make_no_absurd_picture)
{
    // Each link zooms by two: around the circle the last would be eight times the first, which it also equals.
    std::vector<gcpw::Link> links =
        linksBy(4, [](int a, int b) { return b - a == 3 ? Matx33d::eye() : Matx33d(2, 0, -300, 0, 2, -200, 0, 0, 1); });
    const CameraChoice choice = found(linkedBy(4, links));
    for (size_t i = 0; i < choice.cameras.size(); ++i)
        EXPECT_TRUE(checkRange(choice.cameras[i].R));
    if (!choice.cameras.empty())
    {
        const float scale = gcpw::medianFocal(choice.cameras);
        EXPECT_EQ(gcpw::shapeOfPicture(choice.cameras, sizesOf(choice.cameras.size()),
                                       *makeWarper(choice.projection, scale), 0)
                      .fault,
                  "");
    }
}

} // namespace
} // namespace opencv_test
