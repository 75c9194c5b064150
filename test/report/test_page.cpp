// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#include <gtest/gtest.h>
#include <opencv2/imgproc.hpp>
#include "common/synthetic_pair.hpp"
#include "report/pair_page.hpp"

namespace
{

bool says(const std::string& html, const std::string& words)
{
    return html.find(words) != std::string::npos;
}

TEST(Report_Page, without_a_picture_the_reason_and_the_photographs_are_shown)
{
    report::PairRun run;
    run.program = "gcpw_pair";
    run.method = "GCPW";
    run.paths = {"a/<left>.png", "a/right.png"};
    run.source = cv::Mat(60, 80, CV_8UC1, cv::Scalar(90));
    run.target = cv::Mat(60, 80, CV_16UC3, cv::Scalar::all(9000));
    cv::gcpw::Report report;
    report.status = cv::gcpw::Status::NO_ALIGNMENT;
    report.message = "3 < 8 matches";
    run.alignment = cv::gcpw::Alignment({}, cv::Size2d(1, 1), report);
    const std::string html = htmlOf(pageOf(run));
    EXPECT_TRUE(says(html, "Why there is no picture"));
    EXPECT_TRUE(says(html, "3 &lt; 8 matches"));
    EXPECT_TRUE(says(html, "&lt;left&gt;.png"));
    EXPECT_FALSE(says(html, "<left>"));
    EXPECT_FALSE(says(html, "class=\"viewer\""));
}

/// A pair that was stitched.
report::PairRun stitchedPair()
{
    report::PairRun run;
    run.program = "gcpw_pair";
    run.method = "GCPW";
    run.paths = {"left.png", "right.png"};
    makeSyntheticPair(run.source, run.target);
    cv::gcpw::Params params;
    params.meshCols = params.meshRows = 8;
    params.workMegapix = 0.1;
    run.alignment = cv::gcpw::alignPair(run.source, run.target, params);
    run.canvas = cv::gcpw::renderPair(run.alignment, run.source, run.target, run.view);
    run.panorama = cv::gcpw::blendPair(run.canvas, run.blend);
    return run;
}

TEST(Report_Page, a_page_shows_what_was_written)
{
    report::PairRun run = stitchedPair();
    const report::Page whole = pageOf(run);
    EXPECT_EQ(whole.size, run.panorama.size());
    EXPECT_EQ(whole.frame, whole.after.place() | whole.before.place());
    EXPECT_FALSE(says(htmlOf(whole), "cropped"));

    run.crop = cv::Rect(100, 40, run.panorama.cols - 220, run.panorama.rows - 90);
    const report::Page page = pageOf(run);
    EXPECT_EQ(page.size, run.crop.size());
    const double scale = static_cast<double>(page.after.image.cols) / run.panorama.cols;
    EXPECT_NEAR(page.frame.x - page.after.origin.x, scale * run.crop.x, 1);
    EXPECT_NEAR(page.frame.height, scale * run.crop.height, 1);
    cv::Mat beside = page.after.labels.of.clone();
    ASSERT_GT(cv::countNonZero(whole.after.labels.of >= 0), cv::countNonZero(beside >= 0));
    beside(page.frame - page.after.labels.origin).setTo(-1);
    EXPECT_EQ(cv::countNonZero(beside >= 0), 0) << "cuts count that nobody sees";
    EXPECT_TRUE(says(htmlOf(page), cv::format("%d &times; %d px, cropped from %d &times; %d", run.crop.width,
                                              run.crop.height, run.panorama.cols, run.panorama.rows)));
}

TEST(Report_Page, a_pair_of_sixteen_bits_is_shown_as_one_of_eight)
{
    report::PairRun run = stitchedPair();
    const report::Page eight = pageOf(run);
    for (cv::Mat* picture : {&run.source, &run.target})
        picture->convertTo(*picture, CV_16U, 257);
    run.canvas = cv::gcpw::renderPair(run.alignment, run.source, run.target, run.view);
    run.panorama = cv::gcpw::blendPair(run.canvas, run.blend);
    ASSERT_EQ(run.panorama.type(), CV_16UC3);
    const report::Page page = pageOf(run);
    ASSERT_EQ(page.after.image.type(), CV_8UC3);
    const double values = 3.0 * static_cast<double>(eight.after.image.total());
    EXPECT_LT(cv::norm(page.after.image, eight.after.image, cv::NORM_L1) / values, 3);
    EXPECT_EQ(page.after.images[0].image.type(), CV_8UC3);
}

TEST(Report_Page, a_pair_lies_in_one_frame_with_its_homography)
{
    const report::PairRun run = stitchedPair();
    ASSERT_TRUE(run.alignment.ok());
    const report::Page page = pageOf(run);
    // The target is not warped by either method, so that both pictures show it at the same place.
    const evaluation::WarpedImage& before = page.before.images[1];
    const evaluation::WarpedImage& after = page.after.images[1];
    const cv::Rect common = before.place & after.place;
    const cv::Rect in_before = common - before.place.tl();
    const cv::Rect in_after = common - after.place.tl();
    cv::Mat both = before.mask(in_before) & after.mask(in_after);
    cv::erode(both, both, cv::Mat(), cv::Point(-1, -1), 3);
    ASSERT_GT(cv::countNonZero(both), 100000);
    cv::Mat difference;
    cv::absdiff(before.image(in_before), after.image(in_after), difference);
    const cv::Scalar mean = cv::mean(difference, both);
    EXPECT_LT(mean[0] + mean[1] + mean[2], 3 * 3);
    EXPECT_FALSE(page.after.labels.of.empty());
    EXPECT_EQ(page.after.meshes.size(), 1u);
    EXPECT_EQ(page.after.meshes[0].size(), 18u) << "nine rows and nine columns";
}

} // namespace
