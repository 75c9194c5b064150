// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#include <filesystem>
#include <fstream>
#include <gtest/gtest.h>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>
#include "common/deep_zoom.hpp"
#include "common/tiled_tiff.hpp"
#include "scratch_folder.hpp"

namespace fs = std::filesystem;

namespace
{

cv::Mat noise(cv::Size size, int type)
{
    cv::Mat result(size, type);
    cv::RNG(3).fill(result, cv::RNG::UNIFORM, 0, type == CV_16UC3 ? 65536 : 256);
    return result;
}

/// A picture without detail, which JPEG keeps nearly.
cv::Mat slope(cv::Size size)
{
    cv::Mat small(3, 3, CV_8UC3);
    cv::RNG(4).fill(small, cv::RNG::UNIFORM, 30, 220);
    cv::Mat result;
    cv::resize(small, result, size, 0, 0, cv::INTER_LINEAR);
    return result;
}

void feed(PictureSink& sink, const cv::Mat& picture, int rows)
{
    for (int y = 0; y < picture.rows; y += rows)
        sink.add(picture.rowRange(y, std::min(y + rows, picture.rows)));
}

std::string contentOf(const fs::path& path)
{
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
}

size_t filesIn(const fs::path& folder)
{
    return static_cast<size_t>(std::distance(fs::directory_iterator(folder), fs::directory_iterator()));
}

TEST(TiledTiff, keeps_every_bit_in_every_compression)
{
    const ScratchFolder folder;
    for (const int type : {CV_8UC3, CV_16UC3})
        for (const std::string compression : {"none", "lzw", "deflate"})
        {
            const cv::Mat picture = noise(cv::Size(601, 517), type);
            const std::string path = folder.path("pano.tif");
            PictureFormat format;
            format.compression = compression;
            TiledTiff tiff(path, picture.size(), type, format, {});
            feed(tiff, picture, 100);
            tiff.finish();
            const cv::Mat found = cv::imread(path, cv::IMREAD_UNCHANGED);
            ASSERT_EQ(found.type(), type) << compression;
            ASSERT_EQ(found.size(), picture.size());
            EXPECT_EQ(cv::norm(found, picture, cv::NORM_INF), 0) << compression;
        }
}

TEST(TiledTiff, has_the_same_bytes_however_many_rows_come_at_a_time)
{
    const ScratchFolder folder;
    const cv::Mat picture = noise(cv::Size(300, 700), CV_8UC3);
    for (const int rows : {1, 256, 700})
    {
        TiledTiff tiff(folder.path(std::to_string(rows) + ".tif"), picture.size(), CV_8UC3, PictureFormat(), {});
        feed(tiff, picture, rows);
        tiff.finish();
    }
    EXPECT_EQ(contentOf(folder.path("1.tif")), contentOf(folder.path("256.tif")));
    EXPECT_EQ(contentOf(folder.path("1.tif")), contentOf(folder.path("700.tif")));
}

TEST(TiledTiff, leaves_nothing_where_it_is_given_up_and_the_former_file)
{
    const ScratchFolder folder;
    const fs::path path = folder.path("pano.tif");
    std::ofstream(path) << "former";
    {
        TiledTiff tiff(path.string(), cv::Size(300, 700), CV_8UC3, PictureFormat(), {});
        feed(tiff, noise(cv::Size(300, 600), CV_8UC3), 600);
    }
    EXPECT_EQ(filesIn(folder.path()), 1U);
    EXPECT_EQ(contentOf(path), "former");
}

TEST(DeepZoom, each_level_is_the_picture_at_half_the_size_of_the_next)
{
    const ScratchFolder folder;
    cv::Mat picture = slope(cv::Size(1001, 777));
    // Gray: JPEG keeps colours at half the resolution, which is nothing in a picture of 2 px.
    cv::cvtColor(picture, picture, cv::COLOR_BGR2GRAY);
    cv::cvtColor(picture, picture, cv::COLOR_GRAY2BGR);
    DeepZoom zoom(folder.path("pano.dzi"), picture.size(), 95);
    feed(zoom, picture, 64);
    zoom.finish();
    cv::Size size = picture.size();
    cv::Mat expected = picture;
    for (int level = 10; level >= 0; --level)
    {
        cv::Mat found(size, CV_8UC3);
        for (int row = 0; row * 254 < size.height; ++row)
            for (int column = 0; column * 254 < size.width; ++column)
            {
                const fs::path name = fs::path(folder.path("pano_files")) / std::to_string(level) /
                                      (std::to_string(column) + "_" + std::to_string(row) + ".jpg");
                const cv::Mat tile = cv::imread(name.string());
                ASSERT_FALSE(tile.empty()) << name;
                const cv::Point from(std::max(column * 254 - 1, 0), std::max(row * 254 - 1, 0));
                const cv::Rect place(
                    from, cv::Point(std::min(column * 254 + 255, size.width), std::min(row * 254 + 255, size.height)));
                ASSERT_EQ(tile.size(), place.size()) << name;
                cv::Mat target = found(place);
                tile.copyTo(target);
            }
        EXPECT_LE(cv::norm(found, expected, cv::NORM_L1) / (3.0 * size.area()), 3) << "level " << level;
        size = cv::Size((size.width + 1) / 2, (size.height + 1) / 2);
        // The last row or column of an odd number is halved with itself.
        cv::copyMakeBorder(expected, expected, 0, 2 * size.height - expected.rows, 0, 2 * size.width - expected.cols,
                           cv::BORDER_REPLICATE);
        cv::resize(expected, expected, size, 0, 0, cv::INTER_AREA);
    }
    EXPECT_FALSE(fs::exists(folder.path("pano_files/11")));
    EXPECT_NE(contentOf(folder.path("pano.dzi")).find("Width=\"1001\" Height=\"777\""), std::string::npos);
    EXPECT_NE(contentOf(folder.path("pano.html")).find("W = 1001, H = 777"), std::string::npos);
}

TEST(DeepZoom, leaves_nothing_where_it_is_given_up)
{
    const ScratchFolder folder;
    {
        DeepZoom zoom(folder.path("pano.dzi"), cv::Size(600, 600), 95);
        feed(zoom, slope(cv::Size(600, 400)), 100);
    }
    EXPECT_EQ(filesIn(folder.path()), 0U);
}

TEST(DeepZoom, the_page_loads_nothing_but_its_tiles)
{
    const std::string page = DeepZoom::page("a <b> & \"c\"", "pano_files", cv::Size(10, 20));
    EXPECT_EQ(page.find("http"), std::string::npos);
    EXPECT_EQ(page.find("a <b>"), std::string::npos);
    EXPECT_EQ(page.find('@'), std::string::npos);
}

} // namespace
