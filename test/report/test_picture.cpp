// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#include <gtest/gtest.h>
#include "../evaluation/noise_image.hpp"
#include "report/maps.hpp"
#include "report/recorded_seams.hpp"
#include "report/svg.hpp"

namespace
{

using evaluation::WarpedImage;
using report::Picture;

/// A part of a scene at its own place, or shifted.
WarpedImage part(const cv::Mat& scene, cv::Rect place, cv::Point shift = cv::Point())
{
    WarpedImage image;
    image.place = place + shift;
    image.image = scene(place).clone();
    image.corrected = image.image.clone();
    image.mask = cv::Mat(place.size(), CV_8UC1, cv::Scalar(255));
    return image;
}

TEST(Report_Picture, four_turns_are_none_and_one_moves_all_parts_alike)
{
    const cv::Mat scene = noiseImage(cv::Size(120, 80), 1);
    Picture picture;
    picture.image = scene.clone();
    picture.origin = cv::Point(-30, 7);
    picture.images = {part(scene, cv::Rect(10, 20, 50, 40), picture.origin)};
    picture.labels = {picture.origin, cv::Mat(80, 120, CV_16SC1, cv::Scalar(-1))};
    picture.labels.of.at<short>(25, 12) = 3;
    picture.lines.push_back({{cv::Point2d(12, 25) + cv::Point2d(picture.origin)}, false});
    Picture once = picture;
    report::turnRight(once, 1);
    EXPECT_EQ(once.image.size(), cv::Size(80, 120));
    const cv::Point at = once.lines[0].path[0];
    EXPECT_EQ(once.image.at<cv::Vec3b>(at - once.origin), scene.at<cv::Vec3b>(25, 12));
    EXPECT_EQ(once.labels.of.at<short>(at - once.labels.origin), 3);
    EXPECT_EQ(once.images[0].image.at<cv::Vec3b>(at - once.images[0].place.tl()), scene.at<cv::Vec3b>(25, 12));
    Picture whole = picture;
    report::turnRight(whole, 4);
    EXPECT_EQ(whole.origin, picture.origin);
    EXPECT_EQ(whole.images[0].place, picture.images[0].place);
    EXPECT_EQ(cv::norm(whole.image, picture.image, cv::NORM_INF), 0);
    EXPECT_EQ(whole.lines[0].path[0], picture.lines[0].path[0]);
}

TEST(Report_Maps, photographs_that_agree_are_not_coloured_and_shifted_ones_are)
{
    const cv::Mat scene = noiseImage(cv::Size(300, 200), 2);
    const cv::Rect frame(0, 0, 300, 200);
    const WarpedImage left = part(scene, cv::Rect(0, 0, 200, 200));
    const report::Misalignment same = report::misalignmentOf({left, part(scene, cv::Rect(100, 0, 200, 200))}, frame);
    EXPECT_EQ(same.share, 0);
    EXPECT_LT(same.unlikeness.at<float>(100, 150), 1e-6);
    EXPECT_EQ(same.unlikeness.at<float>(100, 50), -1) << "one photograph alone";
    const report::Misalignment off =
        report::misalignmentOf({left, part(scene, cv::Rect(100, 0, 200, 200), cv::Point(6, 0))}, frame);
    EXPECT_GT(off.share, 90);
    const cv::Mat quiet = report::drawn(same, scene);
    const cv::Mat loud = report::drawn(off, scene);
    const auto isGray = [](const cv::Vec3b& p) { return p[0] == p[1] && p[1] == p[2]; };
    EXPECT_TRUE(isGray(quiet.at<cv::Vec3b>(100, 150)));
    EXPECT_FALSE(isGray(loud.at<cv::Vec3b>(100, 150)));
    EXPECT_TRUE(isGray(loud.at<cv::Vec3b>(100, 30)));
}

TEST(Report_Maps, a_lighter_photograph_is_orange_and_a_darker_one_blue)
{
    const cv::Mat scene = noiseImage(cv::Size(200, 100), 3);
    Picture picture;
    picture.images = {part(scene, cv::Rect(0, 0, 100, 100)), part(scene, cv::Rect(100, 0, 100, 100))};
    picture.images[0].image.setTo(cv::Scalar::all(100));
    picture.images[0].corrected.setTo(cv::Scalar::all(130));
    picture.images[1].image.setTo(cv::Scalar::all(100));
    picture.images[1].corrected.setTo(cv::Scalar::all(70));
    const cv::Mat map = report::drawnLight(picture, scene, cv::Rect(0, 0, 200, 100));
    const cv::Vec3b lighter = map.at<cv::Vec3b>(50, 50);
    const cv::Vec3b darker = map.at<cv::Vec3b>(50, 150);
    EXPECT_GT(lighter[2], lighter[0] + 80);
    EXPECT_GT(darker[0], darker[2] + 80);
}

TEST(Report_Svg, a_path_is_short_and_lies_where_its_pixels_are)
{
    const cv::Rect frame(10, 20, 100, 100);
    EXPECT_EQ(report::pathData({{{10, 20}, {15, 20}, {20, 20}}}, frame), "M0.5 0.5l10 0")
        << "points on a straight line are left out";
    EXPECT_EQ(report::pathData({{{10, 20}, {20, 25}, {20, 20}}}, frame), "M0.5 0.5l10 5l0-5");
    EXPECT_EQ(report::pathData({{{500, 500}, {510, 500}}}, frame), "") << "beside the frame";
    EXPECT_EQ(report::pathData({{{10, 20}}, {}}, frame), "");
}

TEST(Report_Svg, cuts_run_between_unlike_labels_and_not_along_the_border_of_nothing)
{
    evaluation::Labels labels = {cv::Point(5, 5), cv::Mat(4, 6, CV_16SC1, cv::Scalar(0))};
    labels.of.colRange(3, 6).setTo(1);
    labels.of.row(0).setTo(-1);
    EXPECT_EQ(report::cutData(labels, cv::Rect(5, 5, 6, 4)), "M3 1v3");
    const std::vector<cv::Point> middles = report::middles(labels, 3, cv::Rect(5, 5, 6, 4));
    EXPECT_EQ(labels.of.at<short>(middles[0]), 0);
    EXPECT_EQ(labels.of.at<short>(middles[1]), 1);
    EXPECT_EQ(middles[2].x, -1);
}

/// A seam finder that parts two images in the middle of what they share.
class Halves : public cv::detail::SeamFinder
{
public:
    void find(const std::vector<cv::UMat>&, const std::vector<cv::Point>&, std::vector<cv::UMat>& masks) override
    {
        masks[0].colRange(30, 40).setTo(0);
        masks[1].colRange(0, 10).setTo(0);
    }
};

TEST(Report_RecordedSeams, every_pixel_is_somebodys_at_another_scale)
{
    report::RecordedSeams seams(cv::makePtr<Halves>());
    std::vector<cv::UMat> masks(2);
    for (cv::UMat& mask : masks)
        mask = cv::UMat(20, 40, CV_8UC1, cv::Scalar(255));
    seams.find(std::vector<cv::UMat>(2), {cv::Point(0, 0), cv::Point(20, 0)}, masks);
    ASSERT_EQ(seams.parts().size(), 2u);
    const cv::Mat scene = noiseImage(cv::Size(423, 140), 4); // 7.05 times as wide
    const evaluation::Labels labels =
        seams.labelsOf({part(scene, cv::Rect(0, 0, 282, 140)), part(scene, cv::Rect(141, 0, 282, 140))});
    EXPECT_EQ(cv::countNonZero(labels.of < 0), 0);
    EXPECT_EQ(labels.of.at<short>(70, 190), 0);
    EXPECT_EQ(labels.of.at<short>(70, 235), 1);
}

} // namespace
