// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#include <cmath>
#include <gtest/gtest.h>
#include <opencv2/imgproc.hpp>
#include "evaluation/seam_visibility.hpp"

namespace
{

using evaluation::SeamVisibility;
using evaluation::seamVisibility;
using evaluation::WarpedImage;

/// Windows of one picture in their places: 60 px wide overlaps, 400 px high.
class Evaluation_SeamVisibility : public ::testing::Test
{
protected:
    void SetUp() override
    {
        picture_ = noise(5);
        images_ = {window(cv::Rect(0, 0, 230, 400)), window(cv::Rect(170, 0, 230, 400))};
    }

    static cv::Mat noise(int seed)
    {
        cv::Mat picture(400, 400, CV_8UC3);
        cv::RNG(static_cast<uint64>(seed)).fill(picture, cv::RNG::UNIFORM, 20, 200);
        cv::GaussianBlur(picture, picture, cv::Size(), 2);
        return picture;
    }

    WarpedImage window(cv::Rect place) const
    {
        WarpedImage image;
        image.place = place + cv::Point(-50, 30); // a canvas does not begin at 0
        image.image = picture_(place).clone();
        image.corrected = image.image.clone();
        image.mask = cv::Mat(place.size(), CV_8UC1, cv::Scalar(255));
        return image;
    }

    /// Differences that grow from the middle of the overlap on, too slowly to be structure: the cheapest cut is there.
    void pullCutToTheMiddle()
    {
        for (int x = 0; x < 60; ++x)
            images_[1].corrected.col(x) += cv::Scalar::all(cvRound(0.4 * std::abs(x - 30)));
    }

    cv::Mat picture_;
    std::vector<WarpedImage> images_;
};

TEST_F(Evaluation_SeamVisibility, a_cut_between_equal_images_cannot_be_seen)
{
    const SeamVisibility seams = seamVisibility(images_);
    EXPECT_GT(seams.pixels, 350);
    EXPECT_NEAR(seams.structure_p95, 0, 1e-9);
    EXPECT_NEAR(seams.worst, 0, 1e-9);
    EXPECT_EQ(seams.gradient_p95, 0);
    EXPECT_EQ(seams.color_p95, 0);
}

TEST_F(Evaluation_SeamVisibility, brightness_shows_in_the_colour_and_not_in_the_structure)
{
    images_[1].corrected += cv::Scalar(0, 20, 5);
    const SeamVisibility seams = seamVisibility(images_);
    EXPECT_NEAR(seams.color_p95, 20, 1e-9);
    EXPECT_LT(seams.structure_p95, 0.01) << "rounding";
    images_[1].image = images_[1].corrected;
    images_[1].corrected = images_[1].image - cv::Scalar(0, 20, 5);
    EXPECT_EQ(seamVisibility(images_).color_p95, 0) << "what is shown counts";
}

TEST_F(Evaluation_SeamVisibility, images_of_different_things_break_every_edge)
{
    picture_ = noise(6);
    images_[1] = window(cv::Rect(170, 0, 230, 400));
    const SeamVisibility seams = seamVisibility(images_);
    EXPECT_GT(seams.structure_p95, 0.3);
    EXPECT_GT(seams.worst, 0.2);
    EXPECT_GT(seams.gradient_p95, 0.3);
}

TEST_F(Evaluation_SeamVisibility, the_one_ugly_place_is_found)
{
    const cv::Rect ugly(0, 200, 60, 40); // all of the overlap's width: no cut goes around it
    pullCutToTheMiddle();
    noise(6)(ugly).copyTo(images_[1].corrected(ugly));
    const SeamVisibility seams = seamVisibility(images_);
    EXPECT_GT(seams.worst, 0.2);
    const cv::Rect on_canvas = ugly + images_[1].place.tl();
    EXPECT_TRUE(on_canvas.contains(seams.worst_place)) << seams.worst_place;
}

TEST_F(Evaluation_SeamVisibility, flat_windows_have_no_structure)
{
    for (WarpedImage& image : images_)
        image.corrected.setTo(cv::Scalar::all(90));
    images_[1].corrected.setTo(cv::Scalar::all(96));
    const SeamVisibility seams = seamVisibility(images_);
    EXPECT_EQ(seams.structure_p95, 0);
    EXPECT_EQ(seams.worst, 0);
    EXPECT_NEAR(seams.color_p95, 6, 1e-9);
}

TEST_F(Evaluation_SeamVisibility, what_a_mask_hides_is_not_looked_at)
{
    const cv::Rect hidden(0, 0, 60, 50);
    pullCutToTheMiddle();
    images_[1].mask(hidden).setTo(0);
    images_[1].corrected(hidden).setTo(0);
    const SeamVisibility seams = seamVisibility(images_);
    EXPECT_GT(seams.pixels, 300);
    EXPECT_LT(seams.pixels, 350);
    EXPECT_LT(seams.structure_p95, 0.1);
}

TEST_F(Evaluation_SeamVisibility, where_nothing_is_cut_there_is_no_answer)
{
    images_[1].place.x += 300;
    for (const std::vector<WarpedImage>& images : {images_, {images_[0]}, std::vector<WarpedImage>()})
    {
        const SeamVisibility seams = seamVisibility(images);
        EXPECT_EQ(seams.pixels, 0);
        EXPECT_TRUE(std::isnan(seams.structure_p95));
        EXPECT_TRUE(std::isnan(seams.worst));
    }
}

} // namespace
