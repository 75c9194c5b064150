// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#include "test_precomp.hpp"

#include "scene.hpp"

namespace opencv_test { namespace {

using namespace cv::gcpw;

Mat whiteNoise(Size size, uint64_t seed)
{
    Mat image(size, CV_8UC3);
    seeded(seed).fill(image, RNG::UNIFORM, 0, 256);
    return image;
}

/// The message of the exception that a pair of images provokes; empty if none.
std::string complaintOf(InputArray source, InputArray target)
{
    try
    {
        alignPair(source, target);
    }
    catch (const cv::Exception& error)
    {
        return error.what();
    }
    return std::string();
}

bool sameMesh(const Alignment& a, const Alignment& b)
{
    return a.ok() && b.ok() && cv::norm(a.image(0).mesh, b.image(0).mesh, NORM_INF) == 0;
}

TEST(Gcpw_PairInput, unrelated_photographs_have_no_alignment_and_a_message_with_the_counts)
{
    const Mat inputs[][2] = {{whiteNoise(Size(320, 240), 1), whiteNoise(Size(320, 240), 2)},
                             {Scene(smallScene()).source(), whiteNoise(Size(320, 240), 3)}};
    for (const auto& pair : inputs)
    {
        const Alignment alignment = alignPair(pair[0], pair[1]);
        EXPECT_EQ(alignment.report().status, Status::NO_ALIGNMENT);
        EXPECT_NE(alignment.report().message.find("needed"), std::string::npos) << alignment.report().message;
        EXPECT_EQ(alignment.imageCount(), 0);
    }
}

TEST(Gcpw_PairInput, two_different_scenes_have_no_alignment)
{
    SceneOptions other = smallScene();
    other.seed = 77;
    const Alignment alignment = alignPair(Scene(smallScene()).source(), Scene(other).target());
    EXPECT_EQ(alignment.report().status, Status::NO_ALIGNMENT) << alignment.report().message;
}

TEST(Gcpw_PairInput, flat_photographs_have_no_alignment)
{
    const Mat flat(240, 320, CV_8UC3, Scalar::all(128));
    const Mat picture = Scene(smallScene()).target();
    EXPECT_EQ(alignPair(flat, flat).report().status, Status::NO_ALIGNMENT);
    EXPECT_EQ(alignPair(flat, picture).report().status, Status::NO_ALIGNMENT);
    EXPECT_EQ(alignPair(picture, flat).report().status, Status::NO_ALIGNMENT);
}

TEST(Gcpw_PairInput, tiny_photographs_have_no_alignment)
{
    const Mat picture = Scene(smallScene()).target();
    for (const Size size : {Size(1, 1), Size(1, 40), Size(40, 1), Size(7, 5)})
    {
        const Mat tiny = picture(Rect(Point(), size));
        EXPECT_EQ(alignPair(tiny, tiny).report().status, Status::NO_ALIGNMENT) << size;
        EXPECT_EQ(alignPair(tiny, picture).report().status, Status::NO_ALIGNMENT) << size;
        EXPECT_EQ(alignPair(picture, tiny).report().status, Status::NO_ALIGNMENT) << size;
    }
}

TEST(Gcpw_PairInput, an_empty_photograph_is_named)
{
    const Mat picture = whiteNoise(Size(64, 64), 1);
    EXPECT_NE(complaintOf(Mat(), picture).find("source"), std::string::npos);
    EXPECT_NE(complaintOf(picture, Mat()).find("target"), std::string::npos);
    EXPECT_EQ(complaintOf(picture, Mat()).find("source image"), std::string::npos);
}

TEST(Gcpw_PairInput, a_photograph_of_another_type_is_named_with_its_type)
{
    const Mat picture = whiteNoise(Size(64, 64), 1);
    const std::string complaint = complaintOf(picture, Mat(64, 64, CV_32FC3, Scalar::all(0)));
    EXPECT_NE(complaint.find("target"), std::string::npos);
    EXPECT_NE(complaint.find("CV_32FC3"), std::string::npos);
    EXPECT_FALSE(complaintOf(Mat(64, 64, CV_8UC2, Scalar::all(0)), picture).empty());
}

TEST(Gcpw_PairInput, params_out_of_range_are_refused_before_any_work)
{
    Params params;
    params.meshCols = 1;
    EXPECT_THROW(alignPair(Mat(), Mat(), params), cv::Exception);
    try
    {
        alignPair(whiteNoise(Size(64, 64), 1), whiteNoise(Size(64, 64), 1), params);
        FAIL() << "accepted";
    }
    catch (const cv::Exception& error)
    {
        EXPECT_NE(std::string(error.what()).find("meshCols"), std::string::npos);
    }
}

TEST(Gcpw_PairInput, sixteen_bits_and_eight_are_the_same_photograph)
{
    const Scene scene{smallScene()};
    Mat deep[2];
    scene.source().convertTo(deep[0], CV_16U, 257);
    scene.target().convertTo(deep[1], CV_16U, 257);
    const Alignment eight = alignPair(scene.source(), scene.target());
    EXPECT_TRUE(sameMesh(eight, alignPair(deep[0], deep[1])));
    EXPECT_TRUE(sameMesh(eight, alignPair(deep[0], scene.target())));
}

TEST(Gcpw_PairInput, a_gray_photograph_is_one_of_equal_channels)
{
    const Scene scene{smallScene()};
    Mat gray[2];
    Mat equal[2];
    cv::cvtColor(scene.source(), gray[0], COLOR_BGR2GRAY);
    cv::cvtColor(scene.target(), gray[1], COLOR_BGR2GRAY);
    for (int i = 0; i < 2; ++i)
        cv::cvtColor(gray[i], equal[i], COLOR_GRAY2BGR);
    const Alignment alignment = alignPair(gray[0], gray[1]);
    EXPECT_TRUE(sameMesh(alignment, alignPair(equal[0], equal[1])));
    EXPECT_LT(scene.meanError(alignment.image(0).mesh), 0.3);
}

TEST(Gcpw_PairInput, full_alpha_changes_nothing)
{
    const Scene scene{smallScene()};
    Mat opaque[2];
    cv::cvtColor(scene.source(), opaque[0], COLOR_BGR2BGRA);
    cv::cvtColor(scene.target(), opaque[1], COLOR_BGR2BGRA);
    EXPECT_TRUE(sameMesh(alignPair(scene.source(), scene.target()), alignPair(opaque[0], opaque[1])));
}

TEST(Gcpw_PairInput, what_alpha_hides_does_not_matter)
{
    const Scene scene{smallScene()};
    const Rect hidden(120, 80, 60, 50);
    Alignment alignments[2];
    for (int i = 0; i < 2; ++i)
    {
        Mat source;
        cv::cvtColor(scene.source(), source, COLOR_BGR2BGRA);
        source(hidden).setTo(i == 0 ? Scalar(0, 0, 0, 0) : Scalar(255, 10, 200, 0));
        alignments[i] = alignPair(source, scene.target());
        ASSERT_TRUE(alignments[i].ok());
        const PairCanvas canvas = renderPair(alignments[i], source, scene.target());
        const Point2d middle = scene.canvasAt(Point2d(150, 105)) + Point2d(canvas.target_origin);
        EXPECT_EQ(canvas.source_mask.at<uchar>(cvRound(middle.y), cvRound(middle.x)), 0);
    }
    EXPECT_TRUE(sameMesh(alignments[0], alignments[1]));
}

TEST(Gcpw_PairInput, a_part_of_a_larger_image_is_as_good_as_a_copy)
{
    const Scene scene{smallScene()};
    Mat frame(280, 360, CV_8UC3, Scalar::all(0));
    Mat part = frame(Rect(20, 20, 320, 240));
    scene.source().copyTo(part);
    EXPECT_TRUE(sameMesh(alignPair(scene.source(), scene.target()), alignPair(part, scene.target())));
}

TEST(Gcpw_PairInput, inputs_are_not_written_to)
{
    const Scene scene{smallScene()};
    const Mat source = scene.source().clone();
    const Mat target = scene.target().clone();
    alignPair(source, target);
    EXPECT_EQ(cv::norm(source, scene.source(), NORM_INF), 0);
    EXPECT_EQ(cv::norm(target, scene.target(), NORM_INF), 0);
}

TEST(Gcpw_PairInput, progress_is_told_and_can_cancel)
{
    const Scene scene{smallScene()};
    std::vector<std::string> stages;
    const auto listen = [&](const std::string& stage, double fraction)
    {
        EXPECT_GE(fraction, 0);
        EXPECT_LE(fraction, 1);
        if (stages.empty() || stages.back() != stage)
            stages.push_back(stage);
        return true;
    };
    ASSERT_TRUE(alignPair(scene.source(), scene.target(), Params(), listen).ok());
    EXPECT_EQ(stages, (std::vector<std::string>{"features", "homography", "align"}));

    const auto stop = [](const std::string& stage, double) { return stage != "align"; };
    const Alignment cancelled = alignPair(scene.source(), scene.target(), Params(), stop);
    EXPECT_EQ(cancelled.report().status, Status::CANCELLED);
    ASSERT_EQ(cancelled.imageCount(), 2);
    EXPECT_EQ(cv::norm(cancelled.image(0).mesh, cancelled.image(0).rough, NORM_INF), 0);
}

}} // namespace
