// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#ifndef GCPW_APPS_DEEP_ZOOM_HPP
#define GCPW_APPS_DEEP_ZOOM_HPP

#include <memory>
#include <string>
#include <vector>
#include "common/partial_file.hpp"
#include "common/picture_sink.hpp"

/// The files of a Deep Zoom picture called NAME.dzi, which tells its size.
struct DeepZoomFiles
{
    explicit DeepZoomFiles(const std::string& path);

    std::string description; ///< NAME.dzi
    std::string tiles;       ///< NAME_files, a folder
    std::string page;        ///< NAME.html, which shows it
};

/** @brief Writes a Deep Zoom pyramid, as OpenSeadragon and other viewers read it, and a page that shows it without any of them.

Tiles are JPEG of 8 bits, 254 px a side and one px of each neighbour. Each level has half the size of the next, as means of 2 x 2 px,
down to a single pixel. */
class DeepZoom : public PictureSink
{
public:
    /// @param path NAME.dzi  @param quality of JPEG, 1 to 100
    DeepZoom(const std::string& path, cv::Size size, int quality);
    ~DeepZoom() override;

    void add(const cv::Mat& rows) override;
    void finish() override;

    /// The text of NAME.dzi.
    static std::string description(cv::Size size);
    /// The page. @param title, tiles as it refers to them
    static std::string page(const std::string& title, const std::string& tiles, cv::Size size);

private:
    struct Level
    {
        cv::Size size;
        int first = 0;    ///< row of the level that `rows` begins with
        int received = 0; ///< rows so far
        int tile_row = 0; ///< the next to be written
        cv::Mat rows;     ///< CV_8UC3, from `first` on
        cv::Mat unpaired; ///< the last row, where it waits for the next to be halved with
    };

    void addTo(size_t level, const cv::Mat& rows);
    void writeTiles(size_t level);
    void writeTileRow(size_t level, const cv::Mat& rows) const;

    std::string path_;
    cv::Size size_;
    int quality_;
    DeepZoomFiles files_;
    PartialFile description_;
    PartialFile tiles_;
    PartialFile page_;
    std::vector<Level> levels_; ///< the last one is the picture
};

#endif
