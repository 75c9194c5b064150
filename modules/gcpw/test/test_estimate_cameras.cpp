// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#include "test_precomp.hpp"

#include <map>
#include <set>
#include <utility>
#include "cameras/link_check.hpp"
#include "stitch_scene.hpp"

namespace opencv_test
{
namespace
{

using gcpw::CameraEstimate;

/// Photographs of a textured sphere by cameras of these turns.
std::vector<Mat> photographsOf(const std::vector<cv::detail::CameraParams>& cameras)
{
    std::vector<Mat> images;
    for (const cv::detail::CameraParams& camera : cameras)
        images.push_back(photographOf(camera, 0, 0));
    return images;
}

/// Largest angle between what is true and what was found from one camera to the next, rad.
double worstTurn(const std::vector<cv::detail::CameraParams>& truth, const CameraEstimate& found)
{
    double worst = 0;
    for (size_t i = 1; i < truth.size(); ++i)
    {
        const Mat true_step = truth[i - 1].R.t() * truth[i].R;
        const Mat step = found.cameras[i - 1].R.t() * found.cameras[i].R;
        worst = std::max(worst, cv::norm(true_step - step));
    }
    return worst;
}

/// The rectangle of the picture on its canvas.
Rect pictureOf(const CameraEstimate& estimate)
{
    std::vector<double> focals;
    for (const cv::detail::CameraParams& camera : estimate.cameras)
        focals.push_back(camera.focal);
    std::sort(focals.begin(), focals.end());
    const Ptr<cv::detail::RotationWarper> warper =
        estimate.warper()->create(static_cast<float>(focals[focals.size() / 2]));
    Rect all;
    for (size_t i = 0; i < estimate.cameras.size(); ++i)
        all |= warper->warpRoi(estimate.images[i].size(), intrinsics(estimate.cameras[i]), estimate.cameras[i].R);
    return all;
}

TEST(Gcpw_EstimateCameras, a_strip_keeps_all_its_photographs_and_their_turns)
{
    const std::vector<cv::detail::CameraParams> truth = {cameraAt(-0.8), cameraAt(-0.4, 0.03), cameraAt(0, -0.02),
                                                         cameraAt(0.4), cameraAt(0.8)};
    const CameraEstimate estimate = gcpw::estimateCameras(photographsOf(truth));
    ASSERT_TRUE(estimate.ok());
    EXPECT_EQ(estimate.component, (std::vector<int>{0, 1, 2, 3, 4}));
    EXPECT_EQ(estimate.projection, "spherical");
    EXPECT_FALSE(estimate.turned);
    EXPECT_LT(worstTurn(truth, estimate), 0.02);
    EXPECT_FALSE(estimate.decisions.empty());
    for (const cv::detail::CameraParams& camera : estimate.cameras)
        EXPECT_NEAR(camera.focal, RIG_FOCAL, 0.04 * RIG_FOCAL);
}

TEST(Gcpw_EstimateCameras, photographs_on_their_side_and_sweeps_upwards_make_no_smear)
{
    std::vector<cv::detail::CameraParams> sideways;
    std::vector<cv::detail::CameraParams> sweep;
    for (const double angle : {-0.8, -0.4, 0.0, 0.4, 0.8})
    {
        sideways.push_back(cameraAt(angle, 0, CV_PI / 2));
        sweep.push_back(cameraAt(0, angle));
    }
    for (const std::vector<cv::detail::CameraParams>& truth : {sideways, sweep})
    {
        const CameraEstimate estimate = gcpw::estimateCameras(photographsOf(truth));
        ASSERT_EQ(estimate.cameras.size(), truth.size());
        EXPECT_TRUE(estimate.turned);
        EXPECT_LT(worstTurn(truth, estimate), 0.02);
        const Rect picture = pictureOf(estimate);
        EXPECT_LT(picture.area(), 5 * RIG_IMAGE.area());
        EXPECT_GT(picture.width, 2 * picture.height) << "turned, the column is wide";
    }
}

TEST(Gcpw_EstimateCameras, the_same_photographs_give_the_same_bits)
{
    const std::vector<Mat> images = photographsOf({cameraAt(-0.4), cameraAt(0), cameraAt(0.4)});
    const CameraEstimate one = gcpw::estimateCameras(images);
    theRNG() = RNG(99);
    const CameraEstimate two = gcpw::estimateCameras(images);
    ASSERT_TRUE(one.ok());
    ASSERT_EQ(one.cameras.size(), two.cameras.size());
    for (size_t i = 0; i < one.cameras.size(); ++i)
    {
        EXPECT_EQ(one.cameras[i].focal, two.cameras[i].focal);
        EXPECT_EQ(cv::norm(one.cameras[i].R, two.cameras[i].R, NORM_INF), 0);
    }
    EXPECT_EQ(one.decisions, two.decisions);
}

TEST(Gcpw_EstimateCameras, photographs_that_match_nothing_are_left_out_and_named)
{
    std::vector<Mat> images = photographsOf({cameraAt(-0.3), cameraAt(0.1)});
    images.insert(images.begin() + 1, Mat(RIG_IMAGE, CV_8UC3, Scalar::all(90)));
    const CameraEstimate estimate = gcpw::estimateCameras(images);
    EXPECT_EQ(estimate.component, (std::vector<int>{0, 2}));
    ASSERT_FALSE(estimate.decisions.empty());
    EXPECT_NE(estimate.decisions.back().find("photograph 2 was left out"), std::string::npos);
    const CameraEstimate none = gcpw::estimateCameras(std::vector<Mat>(2, images[1]));
    EXPECT_FALSE(none.ok());
    EXPECT_FALSE(none.decisions.empty());
}

TEST(Gcpw_EstimateCameras, almost_equal_photographs_belong_together)
{
    // OpenCV's matcher gives such a pair the confidence 0 and a stitcher says that it needs more images.
    const CameraEstimate estimate = gcpw::estimateCameras(photographsOf({cameraAt(0), cameraAt(0.03)}));
    EXPECT_EQ(estimate.component, (std::vector<int>{0, 1}));
    for (const std::string& decision : estimate.decisions)
        EXPECT_EQ(decision.find("few of their keypoints"), std::string::npos) << "all of them match";
}

TEST(Gcpw_EstimateCameras, its_cameras_and_rig_are_those_of_a_stitcher_with_such_a_transform)
{
    const std::vector<Mat> images = frameOf();
    const CameraEstimate estimate = gcpw::estimateCameras(images);
    ASSERT_TRUE(estimate.ok());
    const Ptr<Stitcher> stitcher = makeStitcher();
    stitcher->setWarper(estimate.warper());
    const Ptr<gcpw::StitcherBinding> binding = gcpw::attach(stitcher, quick());
    binding->setRig(gcpw::alignRig(estimate, quick()));
    ASSERT_EQ(stitcher->setTransform(images, estimate.cameras, estimate.component), Stitcher::OK);
    Mat picture;
    ASSERT_EQ(stitcher->composePanorama(picture), Stitcher::OK);
    EXPECT_TRUE(binding->rig().usable());
    EXPECT_EQ(binding->estimations(), 0) << "the stitcher found its cameras to be others";
    EXPECT_EQ(binding->rig().projection, estimate.projection);
}

TEST(Gcpw_EstimateCameras, progress_tells_each_photograph_and_each_pair_and_changes_nothing)
{
    const std::vector<Mat> images = photographsOf({cameraAt(-0.4), cameraAt(0), cameraAt(0.4)});
    std::vector<std::pair<std::string, double>> told;
    const CameraEstimate estimate = gcpw::estimateCameras(images, gcpw::CameraOptions(),
                                                          [&](const std::string& stage, double fraction)
                                                          {
        told.emplace_back(stage, fraction);
        return true;
    });
    const CameraEstimate silent = gcpw::estimateCameras(images);
    EXPECT_EQ(estimate.decisions, silent.decisions);
    EXPECT_EQ(estimate.cameras[0].focal, silent.cameras[0].focal);
    std::map<std::string, std::set<double>> fractions;
    for (size_t i = 0; i < told.size(); ++i)
    {
        fractions[told[i].first].insert(told[i].second);
        if (i > 0 && told[i].first == told[i - 1].first)
        {
            EXPECT_GE(told[i].second, told[i - 1].second) << "time runs backwards";
        }
    }
    EXPECT_EQ(fractions["features"].size(), size_t(4)) << "none, and each of three photographs";
    EXPECT_EQ(fractions["cameras"].size(), size_t(5)) << "none, each of three pairs, and the cameras";
    EXPECT_EQ(*fractions["cameras"].rbegin(), 1.0);
}

TEST(Gcpw_EstimateCameras, cancelled_at_any_time_it_has_no_cameras)
{
    const std::vector<Mat> images = photographsOf({cameraAt(-0.4), cameraAt(0), cameraAt(0.4)});
    for (const std::string at : {"features", "cameras"})
    {
        int calls = 0;
        const CameraEstimate estimate = gcpw::estimateCameras(images, gcpw::CameraOptions(),
                                                              [&](const std::string& stage, double)
                                                              {
            calls += stage == at ? 1 : 0;
            return stage != at;
        });
        EXPECT_EQ(calls, 1) << "called again after it said stop";
        EXPECT_FALSE(estimate.ok());
        ASSERT_FALSE(estimate.decisions.empty());
        EXPECT_NE(estimate.decisions.back().find("cancelled"), std::string::npos);
    }
}

TEST(Gcpw_EstimateCameras, the_median_focal_length_is_that_of_a_stitcher)
{
    std::vector<cv::detail::CameraParams> cameras(4);
    const double focals[] = {900, 300, 500, 400};
    for (size_t i = 0; i < cameras.size(); ++i)
        cameras[i].focal = focals[i];
    EXPECT_EQ(gcpw::medianFocal(cameras), 450.F);
    cameras.pop_back();
    EXPECT_EQ(gcpw::medianFocal(cameras), 500.F);
    EXPECT_THROW(gcpw::medianFocal(std::vector<cv::detail::CameraParams>()), cv::Exception);
}

TEST(Gcpw_EstimateCameras, bad_input_is_refused)
{
    const std::vector<Mat> images = {Mat(60, 80, CV_8UC3, Scalar::all(9)), Mat(60, 80, CV_8UC3, Scalar::all(9))};
    EXPECT_THROW(gcpw::estimateCameras(std::vector<Mat>(1, images[0])), cv::Exception);
    EXPECT_THROW(gcpw::estimateCameras(std::vector<Mat>{images[0], Mat()}), cv::Exception);
    EXPECT_THROW(gcpw::estimateCameras(std::vector<Mat>{images[0], Mat(60, 80, CV_32FC3)}), cv::Exception);
    gcpw::CameraOptions options;
    options.workMegapix = 0;
    EXPECT_THROW(gcpw::estimateCameras(images, options), cv::Exception);
    options = gcpw::CameraOptions();
    options.projection = "ball";
    EXPECT_THROW(gcpw::estimateCameras(images, options), cv::Exception);
    options = gcpw::CameraOptions();
    options.focal = {500};
    EXPECT_THROW(gcpw::estimateCameras(images, options), cv::Exception) << "one length for two photographs";
    options.focal = {500, -1};
    EXPECT_THROW(gcpw::estimateCameras(images, options), cv::Exception);
    EXPECT_THROW(gcpw::alignRig(CameraEstimate()), cv::Exception);
}

TEST(Gcpw_LinkCheck, an_overlap_looks_the_same_under_the_true_homography_only)
{
    const cv::detail::CameraParams a = cameraAt(-0.2);
    const cv::detail::CameraParams b = cameraAt(0.2, 0.05);
    const Mat image_a = photographOf(a, 0, 0);
    const Mat image_b = 0.6 * photographOf(b, 0, 0) + Scalar::all(20); // another exposure
    Mat h = intrinsics(b) * b.R.t() * a.R * intrinsics(a).inv();
    h.convertTo(h, CV_64F);
    const Matx33d b_from_a(h.ptr<double>());
    const std::vector<Point2f> inliers(12, Point2f(250, 150));
    EXPECT_TRUE(gcpw::showTheSame(image_a, image_b, b_from_a, inliers));
    EXPECT_GT(gcpw::lookAtOverlap(image_a, image_b, b_from_a).correlation, 0.9);
    EXPECT_FALSE(gcpw::showTheSame(image_a, image_b, Matx33d(1, 0, -60, 0, 1, 25, 0, 0, 1), inliers))
        << "a wrong homography";
    EXPECT_FALSE(gcpw::showTheSame(image_a, image_b, b_from_a, std::vector<Point2f>(5, Point2f(250, 150))))
        << "too few matches";
    EXPECT_FALSE(gcpw::showTheSame(image_a, image_b, Matx33d(-1, 0, 400, 0, 1, 0, 0, 0, 1), inliers)) << "mirrored";
}

TEST(Gcpw_LinkCheck, links_that_the_pictures_confirm_join_groups_and_close_rings)
{
    // The last photograph is of another place.
    std::vector<Mat> images = photographsOf({cameraAt(-0.3), cameraAt(0), cameraAt(0.3)});
    images.push_back(photographOf(cameraAt(0), 0, 0, 99));
    gcpw::LinkedImages linked;
    cv::detail::computeImageFeatures(SIFT::create(1000), images, linked.features);
    cv::detail::BestOf2NearestMatcher matcher(false, 0.1F);
    matcher(linked.features, linked.matches);
    for (cv::detail::MatchesInfo& info : linked.matches)
        info.confidence = std::min(info.confidence, 0.5);
    EXPECT_EQ(gcpw::groupsOf(linked, 1), (std::vector<int>{0, 1, 2, 3}));
    const std::vector<Vec2i> joined = gcpw::confirmLinks(linked, images, 1);
    EXPECT_EQ(joined, (std::vector<Vec2i>{Vec2i(0, 1), Vec2i(0, 2), Vec2i(1, 2)}));
    EXPECT_EQ(gcpw::groupsOf(linked, 1), (std::vector<int>{0, 0, 0, 1}));
    EXPECT_EQ(gcpw::largestGroup(gcpw::groupsOf(linked, 1)), (std::vector<int>{0, 1, 2}));
}

} // namespace
} // namespace opencv_test
