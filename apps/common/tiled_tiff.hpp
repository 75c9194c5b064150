// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#ifndef GCPW_APPS_TILED_TIFF_HPP
#define GCPW_APPS_TILED_TIFF_HPP

#include <memory>
#include <string>
#include <vector>
#include "common/encode_picture.hpp"
#include "common/partial_file.hpp"
#include "common/picture_sink.hpp"

/** @brief Writes a TIFF file in tiles, of any size: BigTIFF where the pixels take more than 4 GB.

The file has the same bytes however many rows add() is given at a time. */
class TiledTiff : public PictureSink
{
public:
    static const int TILE = 256; ///< px a side, as most programs write them

    /// @param type CV_8UC3 or CV_16UC3  @param profile of the colours, may be empty
    /// @param description what the file says of itself, may be empty
    TiledTiff(const std::string& path, cv::Size size, int type, const PictureFormat& format,
              const std::vector<uchar>& profile, const std::string& description = std::string());
    ~TiledTiff() override;

    void add(const cv::Mat& rows) override;
    void finish() override;

    /// The next tile as a file of the same kind has it, in the place of add().
    void addTile(const std::vector<uchar>& encoded);

private:
    struct File;

    void writeRowOfTiles();

    std::string path_;
    cv::Size size_;
    PartialFile partial_;
    std::unique_ptr<File> file_;
    cv::Mat waiting_; ///< TILE rows, RGB, padded to whole tiles
    int filled_ = 0;  ///< rows of it
    int written_ = 0; ///< tiles
};

#endif
