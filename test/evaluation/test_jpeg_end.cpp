// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#include <gtest/gtest.h>
#include <opencv2/imgcodecs.hpp>
#include "common/jpeg_end.hpp"
#include "scratch_folder.hpp"

namespace
{

/// A photograph's file, with every kind of marker: plain, progressive, with restarts.
std::string jpeg(const std::vector<int>& parameters)
{
    cv::Mat image(60, 80, CV_8UC3);
    cv::RNG(3).fill(image, cv::RNG::UNIFORM, 0, 256);
    std::vector<uchar> data;
    EXPECT_TRUE(cv::imencode(".jpg", image, data, parameters));
    return std::string(data.begin(), data.end());
}

std::vector<std::string> jpegs()
{
    return {jpeg({}), jpeg({cv::IMWRITE_JPEG_PROGRESSIVE, 1}),
            jpeg({cv::IMWRITE_JPEG_RST_INTERVAL, 2, cv::IMWRITE_JPEG_QUALITY, 100})};
}

bool lacksEnd(const ScratchFolder& folder, const std::string& content)
{
    std::ofstream(folder.path("file"), std::ios::binary) << content;
    return lacksJpegEnd(folder.path("file"));
}

/// The same picture with a whole JPEG as preview in its first segment.
std::string withPreview(const std::string& whole, const std::string& preview)
{
    const size_t length = preview.size() + 2;
    const std::string segment{'\xff', '\xe1', static_cast<char>(length / 256), static_cast<char>(length % 256)};
    return whole.substr(0, 2) + segment + preview + whole.substr(2);
}

TEST(JpegEnd, a_file_that_is_cut_anywhere_lacks_it)
{
    const ScratchFolder folder;
    for (const std::string& whole : jpegs())
    {
        EXPECT_FALSE(lacksEnd(folder, whole));
        for (size_t length = 2; length < whole.size(); length += 1 + length / 40)
            EXPECT_TRUE(lacksEnd(folder, whole.substr(0, length))) << length << " of " << whole.size();
        EXPECT_TRUE(lacksEnd(folder, whole.substr(0, whole.size() - 1)));
    }
}

TEST(JpegEnd, that_of_a_preview_is_none)
{
    const ScratchFolder folder;
    const std::string whole = withPreview(jpeg({}), jpeg({}));
    EXPECT_FALSE(lacksEnd(folder, whole));
    EXPECT_TRUE(lacksEnd(folder, whole.substr(0, whole.size() / 2 + 200)));
}

TEST(JpegEnd, something_may_stand_behind_it)
{
    const ScratchFolder folder;
    for (const std::string& whole : jpegs())
        EXPECT_FALSE(lacksEnd(folder, whole + std::string(100, '\0')));
}

TEST(JpegEnd, other_files_need_none)
{
    const ScratchFolder folder;
    for (const char* content : {"", "\xff", "\x89PNG", "text"})
        EXPECT_FALSE(lacksEnd(folder, content));
    EXPECT_FALSE(lacksJpegEnd(folder.path("missing")));
}

} // namespace
