// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#include <cmath>
#include <gtest/gtest.h>
#include <opencv2/imgproc.hpp>
#include "evaluation/bend.hpp"
#include "moved_mesh.hpp"

namespace
{

using cv::gcpw::AlignedImage;
using evaluation::Bend;
using evaluation::bendsOf;
using evaluation::longSegments;
using evaluation::summary;

const cv::Size SIZE(400, 300);
const double HEIGHT = 12; ///< px: of the bow

const std::vector<cv::Vec4f> SEGMENTS = {{-0.5F, 100, 399.5F, 100}, {200, 20, 200, 280}, {20, 20, 380, 280}};

/// Horizontal lines become half a wave.
cv::Vec2d bow(const cv::Vec2d& p, cv::Size size = SIZE)
{
    return {p[0], p[1] + HEIGHT * std::sin(CV_PI * (p[0] + 0.5) / size.width)};
}

cv::Vec2d shift(const cv::Vec2d& p, cv::Size)
{
    return p + cv::Vec2d(9, -6);
}

/// White with a black rectangle: four long edges.
cv::Mat rectanglePicture(cv::Size size)
{
    cv::Mat picture(size, CV_8UC3, cv::Scalar::all(230));
    cv::rectangle(picture, cv::Rect(size.width / 4, size.height / 4, size.width / 2, size.height / 2), cv::Scalar::all(20), cv::FILLED);
    return picture;
}

TEST(Evaluation_Bend, a_mesh_that_did_not_move_bends_nothing)
{
    const AlignedImage image = movedMesh(SIZE, [](const cv::Vec2d& p) { return p; });
    EXPECT_FALSE(evaluation::moves(image));
    const Bend bend = summary(bendsOf(image, SEGMENTS));
    EXPECT_EQ(bend.segments, 3);
    EXPECT_EQ(bend.largest, 0);
    EXPECT_EQ(bend.p95, 0);
    EXPECT_EQ(bend.share, 0);
    EXPECT_EQ(summary({}).p95, 0);
}

TEST(Evaluation_Bend, shift_turn_scale_and_shear_keep_lines_straight)
{
    const AlignedImage image = movedMesh(SIZE, [](const cv::Vec2d& p)
    { return cv::Vec2d(1.1 * p[0] - 0.3 * p[1] + 40, 0.2 * p[0] + 0.9 * p[1] - 25); });
    EXPECT_TRUE(evaluation::moves(image));
    EXPECT_LT(summary(bendsOf(image, SEGMENTS)).largest, 1e-9);
}

TEST(Evaluation_Bend, a_known_bow_gives_its_bend)
{
    const AlignedImage image = movedMesh(SIZE, [](const cv::Vec2d& p) { return bow(p); });
    const std::vector<evaluation::SegmentBend> bends = bendsOf(image, SEGMENTS);
    ASSERT_EQ(bends.size(), 3u);
    // Half a wave less its mean 2 / pi, the slope being 0.
    EXPECT_NEAR(bends[0].largest, HEIGHT * 2 / CV_PI, 0.1);
    EXPECT_NEAR(std::sqrt(bends[0].mean_square), HEIGHT * std::sqrt(0.5 - 4 / (CV_PI * CV_PI)), 0.1);
    EXPECT_NEAR(bends[0].length, SIZE.width, 1e-3);
    EXPECT_NEAR(bends[0].path[bends[0].path.size() / 2].y, 100 + HEIGHT, 0.05);
    EXPECT_LT(bends[1].largest, 1e-9) << "the whole vertical line goes down";
    const Bend bend = summary(bends);
    EXPECT_NEAR(bend.share, 200.0 / 3, 1e-9);
    EXPECT_EQ(bend.largest, std::max(bends[0].largest, bends[2].largest));
    EXPECT_NEAR(bend.p95, bends[2].largest + 0.9 * (bends[0].largest - bends[2].largest), 1e-9);
}

TEST(Evaluation_Bend, a_segment_that_leaves_its_image_is_left_out)
{
    const AlignedImage image = movedMesh(SIZE, [](const cv::Vec2d& p) { return bow(p); });
    EXPECT_TRUE(bendsOf(image, {{-10, 100, 300, 100}}).empty());
    EXPECT_EQ(bendsOf(image, {{0, 100, 300, 100}}, [](cv::Point2d p) { return 0.5 * p; }).size(), 1u);
    EXPECT_TRUE(bendsOf(image, {{0, 100, 300, 100}}, [](cv::Point2d p) { return 2 * p; }).empty());
}

TEST(Evaluation_Bend, segments_are_the_long_edges_at_the_size_asked_for)
{
    cv::Mat picture = rectanglePicture(SIZE * 2);
    cv::rectangle(picture, cv::Rect(40, 40, 30, 30), cv::Scalar::all(20), cv::FILLED); // 15 px: too short
    const std::vector<cv::Vec4f> segments = longSegments(picture, SIZE);
    ASSERT_EQ(segments.size(), 4u);
    for (const cv::Vec4f& s : segments)
        EXPECT_GT(std::hypot(s[2] - s[0], s[3] - s[1]), 0.4 * SIZE.height);
    EXPECT_EQ(longSegments(cv::Mat(SIZE, CV_8UC1, cv::Scalar(90)), SIZE).size(), 0u);
}

/// One photograph on the canvas of a warper, shifted by the law as if it were refined.
class Evaluation_RigBend : public ::testing::TestWithParam<const char*>
{
protected:
    template <typename Law>
    cv::gcpw::Rig rig(Law law) const
    {
        cv::gcpw::Rig rig;
        rig.scale = 350;
        rig.cameras.resize(1);
        rig.cameras[0].focal = 350;
        rig.cameras[0].ppx = 0.5 * SIZE.width;
        rig.cameras[0].ppy = 0.5 * SIZE.height;
        rig.cameras[0].R = cv::Mat::eye(3, 3, CV_32F);
        rig.image_sizes = {SIZE};
        rig.component = {7};
        cv::Mat K;
        rig.cameras[0].K().convertTo(K, CV_32F);
        const cv::Rect roi = cv::PyRotationWarper(GetParam(), rig.scale).warpRoi(SIZE, K, rig.cameras[0].R);
        const double s = 0.75; // canvas at a smaller resolution than the cameras
        const cv::Size size(cvRound(roi.width * s), cvRound(roi.height * s));
        AlignedImage image = movedMesh(size, [&](const cv::Vec2d& p) { return law(p, size); });
        const cv::Scalar origin(roi.x * s, roi.y * s);
        cv::add(image.rough, origin, image.rough);
        cv::add(image.mesh, origin, image.mesh);
        rig.alignment = cv::gcpw::Alignment({image}, cv::Size2d(s, s), cv::gcpw::Report());
        return rig;
    }

    static Bend bendOf(const cv::gcpw::Rig& rig)
    {
        return summary(bendsOf(rig, [](int index)
        {
            EXPECT_EQ(index, 7);
            return rectanglePicture(SIZE * 2);
        }).at(0));
    }
};

TEST_P(Evaluation_RigBend, a_shift_on_the_canvas_bends_no_line_of_the_photograph)
{
    const Bend bend = bendOf(rig(shift));
    EXPECT_EQ(bend.segments, 4);
    EXPECT_LT(bend.largest, 0.05) << "a path that turns feels a shift a little";
    EXPECT_EQ(bendOf(rig([](const cv::Vec2d& p, cv::Size) { return p; })).segments, 0) << "what does not move is not measured";
}

TEST_P(Evaluation_RigBend, a_bow_is_found_through_the_warper)
{
    // Two edges are long and horizontal, half of the photograph: cos from -pi/4 to pi/4 less its mean, at an end.
    const Bend bend = bendOf(rig([](const cv::Vec2d& p, cv::Size size) { return bow(p, size); }));
    EXPECT_EQ(bend.segments, 4);
    EXPECT_NEAR(bend.largest, HEIGHT * (4 / CV_PI * std::sin(CV_PI / 4) - std::cos(CV_PI / 4)), 0.5);
    EXPECT_NEAR(bend.share, 50, 1e-9);
}

INSTANTIATE_TEST_SUITE_P(Warpers, Evaluation_RigBend, ::testing::Values("spherical", "cylindrical", "plane"));

TEST_P(Evaluation_RigBend, a_canvas_of_no_warper_is_refused)
{
    cv::gcpw::Rig other = rig(shift);
    other.cameras[0].ppx += 30;
    EXPECT_THROW(bendOf(other), cv::Exception);
}

} // namespace
