// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#include <functional>
#include <gtest/gtest.h>
#include <opencv2/imgproc.hpp>
#include "common/encode_picture.hpp"
#include "common/exit_code.hpp"
#include "common/read_photograph.hpp"
#include "scratch_folder.hpp"
#include "stored_picture.hpp"

namespace
{

/// A picture that is unlike itself turned or mirrored, smooth enough for JPEG.
cv::Mat scene(int type = CV_8UC3)
{
    cv::Mat picture(60, 90, CV_8UC3);
    for (int y = 0; y < picture.rows; ++y)
        for (int x = 0; x < picture.cols; ++x)
            picture.at<cv::Vec3b>(y, x) =
                cv::Vec3b(static_cast<uchar>(2 * x), static_cast<uchar>(4 * y), static_cast<uchar>(x + y));
    if (CV_MAT_DEPTH(type) == CV_16U)
        picture.convertTo(picture, CV_16U, 257, 77); // 77: what 8 bits would lose
    return picture;
}

/// How a camera stores what stands upright, after the table of EXIF 2.32: where the first row and the first column are.
cv::Mat storedAs(const cv::Mat& upright_picture, int orientation)
{
    cv::Mat stored;
    switch (orientation)
    {
    case 2:
        cv::flip(upright_picture, stored, 1);
        break;
    case 3:
        cv::rotate(upright_picture, stored, cv::ROTATE_180);
        break;
    case 4:
        cv::flip(upright_picture, stored, 0);
        break;
    case 5:
        cv::transpose(upright_picture, stored);
        break;
    case 6: // shown turned to the right, so stored turned to the left
        cv::rotate(upright_picture, stored, cv::ROTATE_90_COUNTERCLOCKWISE);
        break;
    case 7:
    {
        cv::Mat turned;
        cv::rotate(upright_picture, turned, cv::ROTATE_180);
        cv::transpose(turned, stored);
        break;
    }
    case 8:
        cv::rotate(upright_picture, stored, cv::ROTATE_90_CLOCKWISE);
        break;
    default:
        stored = upright_picture;
        break;
    }
    return stored;
}

TEST(ReadPhotograph, every_orientation_stands_upright_in_every_format)
{
    const ScratchFolder folder;
    const cv::Mat expected = scene();
    const std::vector<std::pair<std::string, std::function<std::string(const cv::Mat&, int)>>> formats = {
        {"jpg", stored::jpeg}, {"png", stored::png}, {"webp", stored::webp}, {"tif", [](const cv::Mat& m, int o) {
                                                                                  return stored::tiff(m, o);
                                                                              }}};
    for (const auto& format : formats)
        for (int orientation = 1; orientation <= 8; ++orientation)
        {
            const std::string name = "photo" + std::to_string(orientation) + "." + format.first;
            folder.write(name, format.second(storedAs(expected, orientation), orientation));
            const Photograph photograph = readPhotograph(folder.path(name));
            ASSERT_EQ(photograph.image.size(), expected.size()) << name;
            EXPECT_LE(cv::norm(photograph.image, expected, cv::NORM_INF), format.first == "jpg" ? 8 : 0) << name;
            EXPECT_EQ(photograph.metadata.orientation(), orientation) << name;
        }
}

TEST(ReadPhotograph, sixteen_bits_and_the_profile_go_in_and_out)
{
    const ScratchFolder folder;
    std::string profile(300, 'p'); // not a true one, and passed on as it is
    profile[2] = 1;
    profile[3] = 44; // its length, as ICC has it
    profile[0] = profile[1] = 0;
    const cv::Mat expected = scene(CV_16UC3);
    for (int orientation = 1; orientation <= 8; ++orientation)
    {
        folder.write("deep.tif", stored::tiff(storedAs(expected, orientation), orientation, profile));
        const Photograph photograph = readPhotograph(folder.path("deep.tif"));
        ASSERT_EQ(photograph.image.type(), CV_16UC3) << orientation;
        ASSERT_EQ(photograph.image.size(), expected.size()) << orientation;
        EXPECT_EQ(cv::norm(photograph.image, expected, cv::NORM_INF), 0) << orientation;
        EXPECT_EQ(std::string(photograph.metadata.profile().begin(), photograph.metadata.profile().end()), profile)
            << orientation;
        for (const char* name : {"out.tif", "out.png"})
        {
            writePicture(folder.path(name), photograph.image, PictureFormat(), photograph.metadata);
            const Photograph again = readPhotograph(folder.path(name));
            EXPECT_EQ(again.image.type(), CV_16UC3) << name;
            EXPECT_EQ(cv::norm(again.image, expected, cv::NORM_INF), 0) << name;
            EXPECT_EQ(again.metadata.profile(), photograph.metadata.profile()) << name;
            EXPECT_EQ(again.metadata.orientation(), 1) << name; // it is upright: what turned it is not copied
        }
        for (const char* name : {"out.jpg", "out.webp"})
        {
            writePicture(folder.path(name), photograph.image, PictureFormat(), photograph.metadata);
            const Photograph again = readPhotograph(folder.path(name));
            EXPECT_EQ(again.image.type(), CV_8UC3) << name;
            EXPECT_EQ(again.metadata.profile(), photograph.metadata.profile()) << name;
        }
    }
}

TEST(ReadPhotograph, transparent_pixels_are_told_and_full_ones_are_not)
{
    const ScratchFolder folder;
    cv::Mat picture;
    cv::cvtColor(scene(), picture, cv::COLOR_BGR2BGRA);
    folder.write("full.png", stored::encoded(".png", picture));
    EXPECT_EQ(readPhotograph(folder.path("full.png")).image.type(), CV_8UC3);
    picture(cv::Rect(0, 0, 10, 60)).setTo(cv::Scalar(0, 0, 0, 0));
    folder.write("part.png", stored::encoded(".png", picture));
    const cv::Mat part = readPhotograph(folder.path("part.png")).image;
    ASSERT_EQ(part.type(), CV_8UC4);
    EXPECT_EQ(cv::countNonZero(shownPixels(part)), 80 * 60);
    picture.setTo(cv::Scalar(9, 9, 9, 0));
    folder.write("none.png", stored::encoded(".png", picture));
    EXPECT_THROW(readPhotograph(folder.path("none.png")), FileTrouble);
}

TEST(ReadPhotograph, gray_and_deep_gray_become_colour)
{
    const ScratchFolder folder;
    cv::Mat gray;
    cv::cvtColor(scene(CV_16UC3), gray, cv::COLOR_BGR2GRAY);
    folder.write("gray.png", stored::encoded(".png", gray));
    const cv::Mat image = readPhotograph(folder.path("gray.png")).image;
    ASSERT_EQ(image.type(), CV_16UC3);
    EXPECT_EQ(toBytes(image).type(), CV_8UC3);
}

TEST(ReadPhotograph, what_is_half_there_is_refused)
{
    const ScratchFolder folder;
    cv::Mat noise(200, 300, CV_8UC3);
    cv::RNG(3).fill(noise, cv::RNG::UNIFORM, 0, 256);
    for (const char* ending : {".jpg", ".png", ".tif", ".webp", ".bmp", ".ppm"})
    {
        const std::string whole = stored::encoded(ending, noise);
        const std::string name = std::string("half") + ending;
        folder.write(name, whole.substr(0, whole.size() / 2));
        try
        {
            readPhotograph(folder.path(name));
            ADD_FAILURE() << name << " is taken";
        }
        catch (const FileTrouble& trouble)
        {
            EXPECT_NE(std::string(trouble.what()).find(name), std::string::npos) << trouble.what();
        }
    }
}

} // namespace
