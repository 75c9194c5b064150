// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#include "test_precomp.hpp"

#include <limits>
#include <set>
#include "refusal.hpp"

namespace opencv_test
{
namespace
{

using namespace cv::gcpw;

const double NOT_A_NUMBER = std::numeric_limits<double>::quiet_NaN();
const double ENDLESS = std::numeric_limits<double>::infinity();

/// A colour grid of ones.
Mat gridOf(int rows, int cols)
{
    return Mat(Mat::ones(rows, 6 * cols, CV_32F)).reshape(6);
}

/// An undeformed image, of 4 x 3 quads.
Alignment::Image restingImage()
{
    Alignment::Image image;
    image.full_size = Size(80, 60);
    image.work_size = Size(40, 30);
    image.color = gridOf(3, 4);
    image.mesh.create(4, 5, CV_64FC2);
    for (int row = 0; row < 4; ++row)
        for (int col = 0; col < 5; ++col)
            image.mesh.at<Vec2d>(row, col) = Vec2d(10 * col - 0.5, 10 * row - 0.5);
    image.rough = image.mesh.clone();
    return image;
}

void expectRefused(const Alignment::Image& image, const std::string& part)
{
    const auto make = [&] { Alignment({restingImage(), image}, Size2d(0.5, 0.5), Report()); };
    opencv_test::expectRefused(make, part);
    opencv_test::expectRefused(make, "image 1");
}

TEST(Gcpw_Alignment, images_as_described_are_taken)
{
    const Alignment alignment({restingImage(), restingImage()}, Size2d(0.5, 0.5), Report());
    EXPECT_EQ(alignment.imageCount(), 2);
    EXPECT_EQ(Alignment(std::vector<Alignment::Image>(), Size2d(1, 1), Report()).imageCount(), 0);
}

TEST(Gcpw_Alignment, a_mat_of_another_type_or_size_is_refused_with_its_name)
{
    typedef Mat Alignment::Image::*Part;
    const std::pair<Part, const char*> parts[] = {{&Alignment::Image::mesh, "mesh"},
                                                  {&Alignment::Image::rough, "rough"}};
    for (const auto& part : parts)
    {
        Alignment::Image image = restingImage();
        image.*part.first = (image.*part.first).rowRange(0, 2).clone();
        expectRefused(image, part.second);
        image.*part.first = Mat();
        expectRefused(image, part.second);
        image.*part.first = Mat(4, 5, CV_32FC2, Scalar::all(0));
        expectRefused(image, part.second);
        const int sizes[] = {4, 5, 1};
        image.*part.first = Mat(3, sizes, CV_64FC2, Scalar::all(0));
        expectRefused(image, part.second);
    }
    Alignment::Image image = restingImage();
    for (const Mat& color : {Mat(), Mat(3, 4, CV_32FC(3), Scalar::all(1)), Mat(3, 4, CV_64FC(6))})
    {
        image.color = color;
        expectRefused(image, "color");
    }
}

TEST(Gcpw_Alignment, values_that_are_not_finite_are_refused)
{
    for (const double bad : {NOT_A_NUMBER, ENDLESS})
    {
        Alignment::Image image = restingImage();
        image.mesh.at<Vec2d>(2, 3)[1] = bad;
        expectRefused(image, "mesh");
        image = restingImage();
        image.rough.at<Vec2d>(0, 0)[0] = bad;
        expectRefused(image, "rough");
        image = restingImage();
        image.color.ptr<float>(2)[5] = static_cast<float>(bad);
        expectRefused(image, "color");
        for (const Size2d scale : {Size2d(bad, 1), Size2d(1, bad), Size2d(0, 1), Size2d(1, -2)})
            opencv_test::expectRefused([&] { Alignment({restingImage()}, scale, Report()); }, "canvas scale");
    }
}

TEST(Gcpw_Alignment, sizes_that_no_image_has_are_refused)
{
    for (const Size bad : {Size(0, 60), Size(80, -1), Size(std::numeric_limits<int>::max(), 60)})
    {
        Alignment::Image image = restingImage();
        image.full_size = bad;
        expectRefused(image, "full_size");
        image = restingImage();
        image.work_size = bad;
        expectRefused(image, "work_size");
    }
    Alignment::Image image = restingImage();
    image.color = gridOf(1, 4);
    image.mesh = image.rough = image.mesh.rowRange(0, 2).clone();
    expectRefused(image, "quads");
}

TEST(Gcpw_Alignment, a_status_that_does_not_exist_is_refused)
{
    Report report;
    report.status = static_cast<Status>(77);
    opencv_test::expectRefused([&] { Alignment({restingImage()}, Size2d(1, 1), report); }, "77");
}

TEST(Gcpw_Alignment, a_status_and_a_reason_to_stop_have_names_of_their_own)
{
    std::set<std::string> names;
    for (const Status status : {Status::OK, Status::ROUGH, Status::NO_ALIGNMENT, Status::CANCELLED})
        names.insert(toString(status));
    EXPECT_EQ(names, (std::set<std::string>{"ok", "rough", "no_alignment", "cancelled"}));
    names.clear();
    for (int reason = static_cast<int>(StopReason::ITERATION_LIMIT); reason <= static_cast<int>(StopReason::CANCELLED);
         ++reason)
        names.insert(toString(static_cast<StopReason>(reason)));
    EXPECT_EQ(names.size(), size_t(6));
    EXPECT_EQ(names.count("unknown"), size_t(0));
    EXPECT_STREQ(toString(static_cast<Status>(9)), "unknown");
    EXPECT_STREQ(toString(static_cast<StopReason>(9)), "unknown");
}

TEST(Gcpw_Alignment, an_image_that_is_not_there_is_named)
{
    const Alignment alignment({restingImage()}, Size2d(1, 1), Report());
    opencv_test::expectRefused([&] { alignment.image(-1); }, "no image -1");
    opencv_test::expectRefused([&] { alignment.image(1); }, "no image 1");
    opencv_test::expectRefused([&] { Alignment().image(0); }, "no image 0");
}

} // namespace
} // namespace opencv_test
